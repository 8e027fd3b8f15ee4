(expected: 5:5 M99 P60 in the main program jumps to block N60)
G21 G99
T0101 S500 M3
G0 X50. Z2.
M99 P60
N60 G0 X100.
M30
