(expected: 4:15 the lead falls to 0 after 20 mm, before the end)
T0101 S500 M3 F.2
G0 X50. Z5.
G34 Z-20. F2. K-.1
M30
