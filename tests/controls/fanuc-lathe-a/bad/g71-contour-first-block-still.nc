(expected: 6 PS0065: the first block of the contour of G71 has neither G0 nor G1)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 M8
G0 X30.
G1 Z1.
N20 X50.
M30
