(expected: 4:1 G77 is not known to rodete in the dialect fanuc-lathe-a)
T0101 S500 M3 F.2
G0 X50. Z5.
G77 X1.
M30
