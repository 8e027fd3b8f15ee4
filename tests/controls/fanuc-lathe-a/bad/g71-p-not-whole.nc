(expected: 5:5 P10.5 has a decimal point)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10.5 Q20
N10 G0 X30.
G1 Z-10.
N20 X50.
M30
