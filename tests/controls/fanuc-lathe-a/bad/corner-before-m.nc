(expected: 4:9 PS0051: the block after ',C' is not a G1 motion)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,C1.
M8
Z-5.
M30
