(expected: 4:12 arc with a centre and with radius)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X40. Z0 R9. I5.
M30
