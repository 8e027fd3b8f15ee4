;expected: 3:1 G16 is not supported: plane of two axes
G71 G90 G94 F100
G16 XZ
M30
