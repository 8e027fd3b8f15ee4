(expected: 4 M99 in the main program repeats it)
T0101 S500 M3 F.2
G0 X50. Z5.
M99
M30
