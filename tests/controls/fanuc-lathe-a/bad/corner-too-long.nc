(expected: 4:9 PS0055: the corner takes 3 mm of either line, and the shorter is 2 long)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,C3.
Z3.
M30
