(expected: 4:11 G71 with D: the cycle is written in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 P1 Q2 D2.
M30
