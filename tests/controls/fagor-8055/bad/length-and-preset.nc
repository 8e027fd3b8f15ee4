;expected: 5:5 G92 with Z while the tool's length
G71 G90 G94 F100
T1 D1
G43
G92 Z0
M30
