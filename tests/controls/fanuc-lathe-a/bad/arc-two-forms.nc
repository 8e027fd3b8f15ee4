(expected: 4:12 arc with both a centre and a radius R)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X40. Z0 R9. I5.
M30
