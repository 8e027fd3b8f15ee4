(expected: 4:8 F2 has no decimal point)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X4. F2
M30
