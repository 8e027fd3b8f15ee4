(expected: 6 PS0065: the first motion of the contour of G71)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G2 X30. Z0 R20.
N20 G1 X50.
M30
