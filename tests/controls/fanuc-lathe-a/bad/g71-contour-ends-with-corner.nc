(expected: 7:13 PS0326: the contour of G71 ends with ',R')
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
N20 G1 Z-5. ,R1.
X50.
M30
