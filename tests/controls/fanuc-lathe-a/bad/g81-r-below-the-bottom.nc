(expected: 4 is below the bottom)
T0101 S500 M3 F.2
G0 X50. Z5.
G81 X0 Z-10. R-20.
M30
