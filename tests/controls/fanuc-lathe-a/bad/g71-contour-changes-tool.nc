(expected: 7:8 rodete does not follow a tool change inside the contour of G71)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G1 Z1. T0202
N20 X50.
M30
