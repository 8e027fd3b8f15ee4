(expected: 4:18 P500.5 has a decimal point)
T0101 S500 M3 F.2
G0 X50. Z5.
G82 X0 Z-10. R2. P500.5
M30
