(expected: 4:9 PS0051: the sign of the corner points away from the next line)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. K1.
Z-9.
M30
