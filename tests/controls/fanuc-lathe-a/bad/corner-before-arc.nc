(expected: 4:9 PS0052: no G1 line follows ',R')
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,R1.
G2 X30. Z-5. R5.
M30
