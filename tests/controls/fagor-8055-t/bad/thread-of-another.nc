%0001-A,MX--,
;expected: 5:5 G32 is not known to rodete in the dialect fagor-8055-t
N10 G71 G90
N20 T1 D1
N30 G32 Z-10 F1
N40 M30
