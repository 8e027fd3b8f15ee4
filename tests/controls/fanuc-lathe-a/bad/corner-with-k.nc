(expected: 4:8 PS0051: the block after 'K' is not a G1 motion)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X4. K5.
M30
