%0001-A,MX--,
;expected: 4:21 K is the pitch of a helix in G17, which rodete does not follow
N10 G71 G90
N20 G2 X10 Y0 I5 J0 K2 F100
N30 M30
