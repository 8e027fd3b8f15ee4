(expected: 5:1 U is missing in the first block of G71)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 R1.
G71 P10 Q20
N10 G0 X30.
G1 Z-10.
N20 X50.
M30
