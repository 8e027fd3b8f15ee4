(expected: 4:1 G41 is not supported: nose radius compensation)
T0101 S500 M3 F.2
G0 X50. Z5.
G41 G0 X1.
M30
