(expected: 4:9 PS0051: the block after 'R' is not a G1 motion)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. R1.
M30
