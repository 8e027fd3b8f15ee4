(expected: 4 G41 or G42, but offset 1 has no nose radius in the tool table)
T0101 S500 M3 F.2
G0 X50. Z5.
G41 G0 X1.
M30
