(expected: 7:8 PS0052: no line with G1 comes behind ',C')
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G1 Z1. ,C1.
N20 G2 X50. Z-9. R10.
M30
