(expected: 4:5 there is no subprogram O0099)
T0101 S500 M3 F.2
G0 X50. Z5.
M98 P0099
M30
