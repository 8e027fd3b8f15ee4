(expected: 7:8 PS0055: the corner needs 5 mm of each line, and the shorter line is 4 mm long)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G1 Z1. ,C5.
N20 X50.
M30
