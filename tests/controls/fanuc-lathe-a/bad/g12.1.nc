(expected: 4:1 G12.1 is not supported: polar and cylindrical)
T0101 S500 M3 F.2
G0 X50. Z5.
G12.1
M30
