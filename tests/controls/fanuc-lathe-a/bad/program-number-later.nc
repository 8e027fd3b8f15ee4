(expected: 4 the program ends without M2 or M30)
T0101 S500 M3 F.2
G0 X50. Z5.
O0002
M99
M30
