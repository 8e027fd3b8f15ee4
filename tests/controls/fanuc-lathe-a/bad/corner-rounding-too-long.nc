(expected: 4:9 PS0055: the corner takes 2.414 mm of either line, and the shorter is 1.414 long)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 Z-2. ,R1.
X48. Z-1.
M30
