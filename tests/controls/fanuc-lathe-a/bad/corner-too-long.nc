(expected: 4:9 PS0055: the corner needs 3 mm of each line, and the shorter line is 2 mm long)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,C3.
Z3.
M30
