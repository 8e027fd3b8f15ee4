(expected: 4:19 ',R' is supported only in a G1 line)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X60. Z-5. R30. ,R1.
G1 Z-9.
M30
