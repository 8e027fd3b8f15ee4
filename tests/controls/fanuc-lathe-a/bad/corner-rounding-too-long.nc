(expected: 4:9 PS0055: the corner needs 2.414 mm of each line, and the shorter line is 1.414 mm long)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 Z-2. ,R1.
X48. Z-1.
M30
