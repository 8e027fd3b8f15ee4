;expected: 3:1 G28 is not supported: second spindle, or exchange of axes
G71 G90 G94 F100
G28 Z0
M30
