(expected: 7:4 X and U in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G1 X40. U2.
N20 X50.
M30
