(expected: 5:1 R2.5 in the first block of G73 is not a number of passes)
T0101 S500 M3 F.2
G0 X50. Z5.
G73 U2. W1. R2.5
G73 P10 Q20
N10 G0 X30.
G1 Z-10.
N20 X50.
M30
