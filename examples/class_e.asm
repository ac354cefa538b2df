; 13 slots, 13000 us of light a frame
; 110 words stored in 14 kernels; 110 executed a frame in 14 launches, 32 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 256                                 # pixels from top to bottom
| cols = 256                                 # pixels from left to right
|
| [registers]                                # of one pixel
| analog = ["A", "B", "C", "D", "E", "F", "NEWS"] # analog registers of one pixel
| analog_scratch = "NEWS"                    # register that every analog sequence overwrites
| # one-bit registers of one pixel
| digital = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9", "R10", "R11", "R12"]
| mask = "R0"                                # a word changes `masked` only in pixels where this register is 1
| masked = "R12"                             # the register that `mask` guards; both are "none" on a chip without this
|
| [behaviour]                                # these values are not public: each key has a default
| reset_honours_flag = "no"                  # does rpix reset only where FLAG is 1? "no", "yes" or "unknown" (not public)
| where_reads_flag = false                   # may WHERE read FLAG, which it also writes? (not public)
| where_obeys_flag = false                   # does the analog `where` itself act only where FLAG is 1? (not public)
| or_sources = 3                             # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = "any"                      # most sources of a WHERE word: "any" or a number (not public)
|
| [store]
| words = 1024                               # largest number of ICWs in all stored kernels
| tables_count = true                        # do constant kernel tables count against the store? (not public)
|
| [time]
| analog_word_us = 0.2                       # one analog word (not public)
| digital_word_us = 0.1                      # one digital word (not public)
| launch_us = 1.0                            # overhead of one kernel launch (not public)
| wait_us = 1.0                              # the frame loop's own time at a boundary (not public)
| readout_us = 16700.0                       # reading one analog register, or all taps, of the whole array out (not public)
| digital_retention_us = 1500000.0           # time for which a digital register keeps an unwritten bit
|
| [range]
| full_well_e = 30000.0                      # electrons that PIX, or a tap, can hold (not public)
| register_min_e = -30000.0                  # least value of an analog register, below 0 (not public)
| register_max_e = 30000.0                   # largest value of an analog register, above 0 (not public)
| adc_bits = 8                               # bits of the readout
| adc_offset_lsb = 0.0                       # offset added to the converter code of an exposure of 0 (not public)
| readout = "spread"                         # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
|
| [in]                                       # the global value IN that every pixel can compare with; set between kernels
| in_low = -127                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "e"
.note codes "fixed"
.note level "0"
.note lowering "accumulate"

.source
| # Every pixel opens in whatever slots its 13 bits say (class e). One bit a slot is one register a
| # slot, and SCAMP-5 has thirteen registers of one bit.
| nsl 1
|
| frame 13 slots of 1ms
|
| code bits : bit[N]
| open when bits[n]
|
| pixels bits = (2917 * x + 4421 * y) % (1 << N)

.wait 1000us x13

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 6 words, 2.1 us; launched at 1
    WHERE R12
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k2                               ; 6 words, 2.1 us; launched at 2
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k3                               ; 6 words, 2.1 us; launched at 3
    WHERE R1
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k4                               ; 6 words, 2.1 us; launched at 4
    WHERE R2
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k5                               ; 6 words, 2.1 us; launched at 5
    WHERE R3
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k6                               ; 6 words, 2.1 us; launched at 6
    WHERE R4
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k7                               ; 6 words, 2.1 us; launched at 7
    WHERE R5
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k8                               ; 6 words, 2.1 us; launched at 8
    WHERE R6
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k9                               ; 6 words, 2.1 us; launched at 9
    WHERE R7
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k10                              ; 6 words, 2.1 us; launched at 10
    WHERE R8
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k11                              ; 6 words, 2.1 us; launched at 11
    WHERE R9
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k12                              ; 6 words, 2.1 us; launched at 12
    WHERE R10
    bus NEWS, A, PIX
    bus A, B, NEWS
    rpix
    rpix
    nop

.kernel k13                              ; 30 words, 4.2 us; launched at 13
    WHERE R11
    bus NEWS, A, PIX
    bus A, B, NEWS
    WHERE R0
    SET R0
    REFRESH R12
    MOV R0, FLAG
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4
    REFRESH R5
    REFRESH R6
    REFRESH R7
    REFRESH R8
    REFRESH R9
    REFRESH R10
    REFRESH R11

.slot 0 k0
.slot 1 k1
.slot 2 k2
.slot 3 k3
.slot 4 k4
.slot 5 k5
.slot 6 k6
.slot 7 k7
.slot 8 k8
.slot 9 k9
.slot 10 k10
.slot 11 k11
.slot 12 k12
.slot 13 k13

.bucket frame
.readout A frame 1

.load R12 R1 R2 R3 R4 R5 R6 R7 R8 R9 R10 R11 R0
.fields bits
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 never             ; 0
.shutter 0000000000010 12                ; 1
.shutter 0000000000100 11                ; 2
.shutter 0000000000110 11..12            ; 3
.shutter 0000000001000 10                ; 4
.shutter 0000000001010 10,12             ; 5
.shutter 0000000001100 10..11            ; 6
.shutter 0000000001110 10..12            ; 7
.shutter 0000000010000 9                 ; 8
.shutter 0000000010010 9,12              ; 9
.shutter 0000000010100 9,11              ; 10
.shutter 0000000010110 9,11..12          ; 11
.shutter 0000000011000 9..10             ; 12
.shutter 0000000011010 9..10,12          ; 13
.shutter 0000000011100 9..11             ; 14
.shutter 0000000011110 9..12             ; 15
.shutter 0000000100000 8                 ; 16
.shutter 0000000100010 8,12              ; 17
.shutter 0000000100100 8,11              ; 18
.shutter 0000000100110 8,11..12          ; 19
.shutter 0000000101000 8,10              ; 20
.shutter 0000000101010 8,10,12           ; 21
.shutter 0000000101100 8,10..11          ; 22
.shutter 0000000101110 8,10..12          ; 23
.shutter 0000000110000 8..9              ; 24
.shutter 0000000110010 8..9,12           ; 25
.shutter 0000000110100 8..9,11           ; 26
.shutter 0000000110110 8..9,11..12       ; 27
.shutter 0000000111000 8..10             ; 28
.shutter 0000000111010 8..10,12          ; 29
.shutter 0000000111100 8..11             ; 30
.shutter 0000000111110 8..12             ; 31
.shutter 0000001000000 7                 ; 32
.shutter 0000001000010 7,12              ; 33
.shutter 0000001000100 7,11              ; 34
.shutter 0000001000110 7,11..12          ; 35
.shutter 0000001001000 7,10              ; 36
.shutter 0000001001010 7,10,12           ; 37
.shutter 0000001001100 7,10..11          ; 38
.shutter 0000001001110 7,10..12          ; 39
.shutter 0000001010000 7,9               ; 40
.shutter 0000001010010 7,9,12            ; 41
.shutter 0000001010100 7,9,11            ; 42
.shutter 0000001010110 7,9,11..12        ; 43
.shutter 0000001011000 7,9..10           ; 44
.shutter 0000001011010 7,9..10,12        ; 45
.shutter 0000001011100 7,9..11           ; 46
.shutter 0000001011110 7,9..12           ; 47
.shutter 0000001100000 7..8              ; 48
.shutter 0000001100010 7..8,12           ; 49
.shutter 0000001100100 7..8,11           ; 50
.shutter 0000001100110 7..8,11..12       ; 51
.shutter 0000001101000 7..8,10           ; 52
.shutter 0000001101010 7..8,10,12        ; 53
.shutter 0000001101100 7..8,10..11       ; 54
.shutter 0000001101110 7..8,10..12       ; 55
.shutter 0000001110000 7..9              ; 56
.shutter 0000001110010 7..9,12           ; 57
.shutter 0000001110100 7..9,11           ; 58
.shutter 0000001110110 7..9,11..12       ; 59
.shutter 0000001111000 7..10             ; 60
.shutter 0000001111010 7..10,12          ; 61
.shutter 0000001111100 7..11             ; 62
.shutter 0000001111110 7..12             ; 63
.shutter 0000010000000 6                 ; 64
.shutter 0000010000010 6,12              ; 65
.shutter 0000010000100 6,11              ; 66
.shutter 0000010000110 6,11..12          ; 67
.shutter 0000010001000 6,10              ; 68
.shutter 0000010001010 6,10,12           ; 69
.shutter 0000010001100 6,10..11          ; 70
.shutter 0000010001110 6,10..12          ; 71
.shutter 0000010010000 6,9               ; 72
.shutter 0000010010010 6,9,12            ; 73
.shutter 0000010010100 6,9,11            ; 74
.shutter 0000010010110 6,9,11..12        ; 75
.shutter 0000010011000 6,9..10           ; 76
.shutter 0000010011010 6,9..10,12        ; 77
.shutter 0000010011100 6,9..11           ; 78
.shutter 0000010011110 6,9..12           ; 79
.shutter 0000010100000 6,8               ; 80
.shutter 0000010100010 6,8,12            ; 81
.shutter 0000010100100 6,8,11            ; 82
.shutter 0000010100110 6,8,11..12        ; 83
.shutter 0000010101000 6,8,10            ; 84
.shutter 0000010101010 6,8,10,12         ; 85
.shutter 0000010101100 6,8,10..11        ; 86
.shutter 0000010101110 6,8,10..12        ; 87
.shutter 0000010110000 6,8..9            ; 88
.shutter 0000010110010 6,8..9,12         ; 89
.shutter 0000010110100 6,8..9,11         ; 90
.shutter 0000010110110 6,8..9,11..12     ; 91
.shutter 0000010111000 6,8..10           ; 92
.shutter 0000010111010 6,8..10,12        ; 93
.shutter 0000010111100 6,8..11           ; 94
.shutter 0000010111110 6,8..12           ; 95
.shutter 0000011000000 6..7              ; 96
.shutter 0000011000010 6..7,12           ; 97
.shutter 0000011000100 6..7,11           ; 98
.shutter 0000011000110 6..7,11..12       ; 99
.shutter 0000011001000 6..7,10           ; 100
.shutter 0000011001010 6..7,10,12        ; 101
.shutter 0000011001100 6..7,10..11       ; 102
.shutter 0000011001110 6..7,10..12       ; 103
.shutter 0000011010000 6..7,9            ; 104
.shutter 0000011010010 6..7,9,12         ; 105
.shutter 0000011010100 6..7,9,11         ; 106
.shutter 0000011010110 6..7,9,11..12     ; 107
.shutter 0000011011000 6..7,9..10        ; 108
.shutter 0000011011010 6..7,9..10,12     ; 109
.shutter 0000011011100 6..7,9..11        ; 110
.shutter 0000011011110 6..7,9..12        ; 111
.shutter 0000011100000 6..8              ; 112
.shutter 0000011100010 6..8,12           ; 113
.shutter 0000011100100 6..8,11           ; 114
.shutter 0000011100110 6..8,11..12       ; 115
.shutter 0000011101000 6..8,10           ; 116
.shutter 0000011101010 6..8,10,12        ; 117
.shutter 0000011101100 6..8,10..11       ; 118
.shutter 0000011101110 6..8,10..12       ; 119
.shutter 0000011110000 6..9              ; 120
.shutter 0000011110010 6..9,12           ; 121
.shutter 0000011110100 6..9,11           ; 122
.shutter 0000011110110 6..9,11..12       ; 123
.shutter 0000011111000 6..10             ; 124
.shutter 0000011111010 6..10,12          ; 125
.shutter 0000011111100 6..11             ; 126
.shutter 0000011111110 6..12             ; 127
.shutter 0000100000000 5                 ; 128
.shutter 0000100000010 5,12              ; 129
.shutter 0000100000100 5,11              ; 130
.shutter 0000100000110 5,11..12          ; 131
.shutter 0000100001000 5,10              ; 132
.shutter 0000100001010 5,10,12           ; 133
.shutter 0000100001100 5,10..11          ; 134
.shutter 0000100001110 5,10..12          ; 135
.shutter 0000100010000 5,9               ; 136
.shutter 0000100010010 5,9,12            ; 137
.shutter 0000100010100 5,9,11            ; 138
.shutter 0000100010110 5,9,11..12        ; 139
.shutter 0000100011000 5,9..10           ; 140
.shutter 0000100011010 5,9..10,12        ; 141
.shutter 0000100011100 5,9..11           ; 142
.shutter 0000100011110 5,9..12           ; 143
.shutter 0000100100000 5,8               ; 144
.shutter 0000100100010 5,8,12            ; 145
.shutter 0000100100100 5,8,11            ; 146
.shutter 0000100100110 5,8,11..12        ; 147
.shutter 0000100101000 5,8,10            ; 148
.shutter 0000100101010 5,8,10,12         ; 149
.shutter 0000100101100 5,8,10..11        ; 150
.shutter 0000100101110 5,8,10..12        ; 151
.shutter 0000100110000 5,8..9            ; 152
.shutter 0000100110010 5,8..9,12         ; 153
.shutter 0000100110100 5,8..9,11         ; 154
.shutter 0000100110110 5,8..9,11..12     ; 155
.shutter 0000100111000 5,8..10           ; 156
.shutter 0000100111010 5,8..10,12        ; 157
.shutter 0000100111100 5,8..11           ; 158
.shutter 0000100111110 5,8..12           ; 159
.shutter 0000101000000 5,7               ; 160
.shutter 0000101000010 5,7,12            ; 161
.shutter 0000101000100 5,7,11            ; 162
.shutter 0000101000110 5,7,11..12        ; 163
.shutter 0000101001000 5,7,10            ; 164
.shutter 0000101001010 5,7,10,12         ; 165
.shutter 0000101001100 5,7,10..11        ; 166
.shutter 0000101001110 5,7,10..12        ; 167
.shutter 0000101010000 5,7,9             ; 168
.shutter 0000101010010 5,7,9,12          ; 169
.shutter 0000101010100 5,7,9,11          ; 170
.shutter 0000101010110 5,7,9,11..12      ; 171
.shutter 0000101011000 5,7,9..10         ; 172
.shutter 0000101011010 5,7,9..10,12      ; 173
.shutter 0000101011100 5,7,9..11         ; 174
.shutter 0000101011110 5,7,9..12         ; 175
.shutter 0000101100000 5,7..8            ; 176
.shutter 0000101100010 5,7..8,12         ; 177
.shutter 0000101100100 5,7..8,11         ; 178
.shutter 0000101100110 5,7..8,11..12     ; 179
.shutter 0000101101000 5,7..8,10         ; 180
.shutter 0000101101010 5,7..8,10,12      ; 181
.shutter 0000101101100 5,7..8,10..11     ; 182
.shutter 0000101101110 5,7..8,10..12     ; 183
.shutter 0000101110000 5,7..9            ; 184
.shutter 0000101110010 5,7..9,12         ; 185
.shutter 0000101110100 5,7..9,11         ; 186
.shutter 0000101110110 5,7..9,11..12     ; 187
.shutter 0000101111000 5,7..10           ; 188
.shutter 0000101111010 5,7..10,12        ; 189
.shutter 0000101111100 5,7..11           ; 190
.shutter 0000101111110 5,7..12           ; 191
.shutter 0000110000000 5..6              ; 192
.shutter 0000110000010 5..6,12           ; 193
.shutter 0000110000100 5..6,11           ; 194
.shutter 0000110000110 5..6,11..12       ; 195
.shutter 0000110001000 5..6,10           ; 196
.shutter 0000110001010 5..6,10,12        ; 197
.shutter 0000110001100 5..6,10..11       ; 198
.shutter 0000110001110 5..6,10..12       ; 199
.shutter 0000110010000 5..6,9            ; 200
.shutter 0000110010010 5..6,9,12         ; 201
.shutter 0000110010100 5..6,9,11         ; 202
.shutter 0000110010110 5..6,9,11..12     ; 203
.shutter 0000110011000 5..6,9..10        ; 204
.shutter 0000110011010 5..6,9..10,12     ; 205
.shutter 0000110011100 5..6,9..11        ; 206
.shutter 0000110011110 5..6,9..12        ; 207
.shutter 0000110100000 5..6,8            ; 208
.shutter 0000110100010 5..6,8,12         ; 209
.shutter 0000110100100 5..6,8,11         ; 210
.shutter 0000110100110 5..6,8,11..12     ; 211
.shutter 0000110101000 5..6,8,10         ; 212
.shutter 0000110101010 5..6,8,10,12      ; 213
.shutter 0000110101100 5..6,8,10..11     ; 214
.shutter 0000110101110 5..6,8,10..12     ; 215
.shutter 0000110110000 5..6,8..9         ; 216
.shutter 0000110110010 5..6,8..9,12      ; 217
.shutter 0000110110100 5..6,8..9,11      ; 218
.shutter 0000110110110 5..6,8..9,11..12  ; 219
.shutter 0000110111000 5..6,8..10        ; 220
.shutter 0000110111010 5..6,8..10,12     ; 221
.shutter 0000110111100 5..6,8..11        ; 222
.shutter 0000110111110 5..6,8..12        ; 223
.shutter 0000111000000 5..7              ; 224
.shutter 0000111000010 5..7,12           ; 225
.shutter 0000111000100 5..7,11           ; 226
.shutter 0000111000110 5..7,11..12       ; 227
.shutter 0000111001000 5..7,10           ; 228
.shutter 0000111001010 5..7,10,12        ; 229
.shutter 0000111001100 5..7,10..11       ; 230
.shutter 0000111001110 5..7,10..12       ; 231
.shutter 0000111010000 5..7,9            ; 232
.shutter 0000111010010 5..7,9,12         ; 233
.shutter 0000111010100 5..7,9,11         ; 234
.shutter 0000111010110 5..7,9,11..12     ; 235
.shutter 0000111011000 5..7,9..10        ; 236
.shutter 0000111011010 5..7,9..10,12     ; 237
.shutter 0000111011100 5..7,9..11        ; 238
.shutter 0000111011110 5..7,9..12        ; 239
.shutter 0000111100000 5..8              ; 240
.shutter 0000111100010 5..8,12           ; 241
.shutter 0000111100100 5..8,11           ; 242
.shutter 0000111100110 5..8,11..12       ; 243
.shutter 0000111101000 5..8,10           ; 244
.shutter 0000111101010 5..8,10,12        ; 245
.shutter 0000111101100 5..8,10..11       ; 246
.shutter 0000111101110 5..8,10..12       ; 247
.shutter 0000111110000 5..9              ; 248
.shutter 0000111110010 5..9,12           ; 249
.shutter 0000111110100 5..9,11           ; 250
.shutter 0000111110110 5..9,11..12       ; 251
.shutter 0000111111000 5..10             ; 252
.shutter 0000111111010 5..10,12          ; 253
.shutter 0000111111100 5..11             ; 254
.shutter 0000111111110 5..12             ; 255
.shutter 0001000000000 4                 ; 256
.shutter 0001000000010 4,12              ; 257
.shutter 0001000000100 4,11              ; 258
.shutter 0001000000110 4,11..12          ; 259
.shutter 0001000001000 4,10              ; 260
.shutter 0001000001010 4,10,12           ; 261
.shutter 0001000001100 4,10..11          ; 262
.shutter 0001000001110 4,10..12          ; 263
.shutter 0001000010000 4,9               ; 264
.shutter 0001000010010 4,9,12            ; 265
.shutter 0001000010100 4,9,11            ; 266
.shutter 0001000010110 4,9,11..12        ; 267
.shutter 0001000011000 4,9..10           ; 268
.shutter 0001000011010 4,9..10,12        ; 269
.shutter 0001000011100 4,9..11           ; 270
.shutter 0001000011110 4,9..12           ; 271
.shutter 0001000100000 4,8               ; 272
.shutter 0001000100010 4,8,12            ; 273
.shutter 0001000100100 4,8,11            ; 274
.shutter 0001000100110 4,8,11..12        ; 275
.shutter 0001000101000 4,8,10            ; 276
.shutter 0001000101010 4,8,10,12         ; 277
.shutter 0001000101100 4,8,10..11        ; 278
.shutter 0001000101110 4,8,10..12        ; 279
.shutter 0001000110000 4,8..9            ; 280
.shutter 0001000110010 4,8..9,12         ; 281
.shutter 0001000110100 4,8..9,11         ; 282
.shutter 0001000110110 4,8..9,11..12     ; 283
.shutter 0001000111000 4,8..10           ; 284
.shutter 0001000111010 4,8..10,12        ; 285
.shutter 0001000111100 4,8..11           ; 286
.shutter 0001000111110 4,8..12           ; 287
.shutter 0001001000000 4,7               ; 288
.shutter 0001001000010 4,7,12            ; 289
.shutter 0001001000100 4,7,11            ; 290
.shutter 0001001000110 4,7,11..12        ; 291
.shutter 0001001001000 4,7,10            ; 292
.shutter 0001001001010 4,7,10,12         ; 293
.shutter 0001001001100 4,7,10..11        ; 294
.shutter 0001001001110 4,7,10..12        ; 295
.shutter 0001001010000 4,7,9             ; 296
.shutter 0001001010010 4,7,9,12          ; 297
.shutter 0001001010100 4,7,9,11          ; 298
.shutter 0001001010110 4,7,9,11..12      ; 299
.shutter 0001001011000 4,7,9..10         ; 300
.shutter 0001001011010 4,7,9..10,12      ; 301
.shutter 0001001011100 4,7,9..11         ; 302
.shutter 0001001011110 4,7,9..12         ; 303
.shutter 0001001100000 4,7..8            ; 304
.shutter 0001001100010 4,7..8,12         ; 305
.shutter 0001001100100 4,7..8,11         ; 306
.shutter 0001001100110 4,7..8,11..12     ; 307
.shutter 0001001101000 4,7..8,10         ; 308
.shutter 0001001101010 4,7..8,10,12      ; 309
.shutter 0001001101100 4,7..8,10..11     ; 310
.shutter 0001001101110 4,7..8,10..12     ; 311
.shutter 0001001110000 4,7..9            ; 312
.shutter 0001001110010 4,7..9,12         ; 313
.shutter 0001001110100 4,7..9,11         ; 314
.shutter 0001001110110 4,7..9,11..12     ; 315
.shutter 0001001111000 4,7..10           ; 316
.shutter 0001001111010 4,7..10,12        ; 317
.shutter 0001001111100 4,7..11           ; 318
.shutter 0001001111110 4,7..12           ; 319
.shutter 0001010000000 4,6               ; 320
.shutter 0001010000010 4,6,12            ; 321
.shutter 0001010000100 4,6,11            ; 322
.shutter 0001010000110 4,6,11..12        ; 323
.shutter 0001010001000 4,6,10            ; 324
.shutter 0001010001010 4,6,10,12         ; 325
.shutter 0001010001100 4,6,10..11        ; 326
.shutter 0001010001110 4,6,10..12        ; 327
.shutter 0001010010000 4,6,9             ; 328
.shutter 0001010010010 4,6,9,12          ; 329
.shutter 0001010010100 4,6,9,11          ; 330
.shutter 0001010010110 4,6,9,11..12      ; 331
.shutter 0001010011000 4,6,9..10         ; 332
.shutter 0001010011010 4,6,9..10,12      ; 333
.shutter 0001010011100 4,6,9..11         ; 334
.shutter 0001010011110 4,6,9..12         ; 335
.shutter 0001010100000 4,6,8             ; 336
.shutter 0001010100010 4,6,8,12          ; 337
.shutter 0001010100100 4,6,8,11          ; 338
.shutter 0001010100110 4,6,8,11..12      ; 339
.shutter 0001010101000 4,6,8,10          ; 340
.shutter 0001010101010 4..12/2           ; 341
.shutter 0001010101100 4,6,8,10..11      ; 342
.shutter 0001010101110 4,6,8,10..12      ; 343
.shutter 0001010110000 4,6,8..9          ; 344
.shutter 0001010110010 4,6,8..9,12       ; 345
.shutter 0001010110100 4,6,8..9,11       ; 346
.shutter 0001010110110 4,6,8..9,11..12   ; 347
.shutter 0001010111000 4,6,8..10         ; 348
.shutter 0001010111010 4,6,8..10,12      ; 349
.shutter 0001010111100 4,6,8..11         ; 350
.shutter 0001010111110 4,6,8..12         ; 351
.shutter 0001011000000 4,6..7            ; 352
.shutter 0001011000010 4,6..7,12         ; 353
.shutter 0001011000100 4,6..7,11         ; 354
.shutter 0001011000110 4,6..7,11..12     ; 355
.shutter 0001011001000 4,6..7,10         ; 356
.shutter 0001011001010 4,6..7,10,12      ; 357
.shutter 0001011001100 4,6..7,10..11     ; 358
.shutter 0001011001110 4,6..7,10..12     ; 359
.shutter 0001011010000 4,6..7,9          ; 360
.shutter 0001011010010 4,6..7,9,12       ; 361
.shutter 0001011010100 4,6..7,9,11       ; 362
.shutter 0001011010110 4,6..7,9,11..12   ; 363
.shutter 0001011011000 4,6..7,9..10      ; 364
.shutter 0001011011010 4,6..7,9..10,12   ; 365
.shutter 0001011011100 4,6..7,9..11      ; 366
.shutter 0001011011110 4,6..7,9..12      ; 367
.shutter 0001011100000 4,6..8            ; 368
.shutter 0001011100010 4,6..8,12         ; 369
.shutter 0001011100100 4,6..8,11         ; 370
.shutter 0001011100110 4,6..8,11..12     ; 371
.shutter 0001011101000 4,6..8,10         ; 372
.shutter 0001011101010 4,6..8,10,12      ; 373
.shutter 0001011101100 4,6..8,10..11     ; 374
.shutter 0001011101110 4,6..8,10..12     ; 375
.shutter 0001011110000 4,6..9            ; 376
.shutter 0001011110010 4,6..9,12         ; 377
.shutter 0001011110100 4,6..9,11         ; 378
.shutter 0001011110110 4,6..9,11..12     ; 379
.shutter 0001011111000 4,6..10           ; 380
.shutter 0001011111010 4,6..10,12        ; 381
.shutter 0001011111100 4,6..11           ; 382
.shutter 0001011111110 4,6..12           ; 383
.shutter 0001100000000 4..5              ; 384
.shutter 0001100000010 4..5,12           ; 385
.shutter 0001100000100 4..5,11           ; 386
.shutter 0001100000110 4..5,11..12       ; 387
.shutter 0001100001000 4..5,10           ; 388
.shutter 0001100001010 4..5,10,12        ; 389
.shutter 0001100001100 4..5,10..11       ; 390
.shutter 0001100001110 4..5,10..12       ; 391
.shutter 0001100010000 4..5,9            ; 392
.shutter 0001100010010 4..5,9,12         ; 393
.shutter 0001100010100 4..5,9,11         ; 394
.shutter 0001100010110 4..5,9,11..12     ; 395
.shutter 0001100011000 4..5,9..10        ; 396
.shutter 0001100011010 4..5,9..10,12     ; 397
.shutter 0001100011100 4..5,9..11        ; 398
.shutter 0001100011110 4..5,9..12        ; 399
.shutter 0001100100000 4..5,8            ; 400
.shutter 0001100100010 4..5,8,12         ; 401
.shutter 0001100100100 4..5,8,11         ; 402
.shutter 0001100100110 4..5,8,11..12     ; 403
.shutter 0001100101000 4..5,8,10         ; 404
.shutter 0001100101010 4..5,8,10,12      ; 405
.shutter 0001100101100 4..5,8,10..11     ; 406
.shutter 0001100101110 4..5,8,10..12     ; 407
.shutter 0001100110000 4..5,8..9         ; 408
.shutter 0001100110010 4..5,8..9,12      ; 409
.shutter 0001100110100 4..5,8..9,11      ; 410
.shutter 0001100110110 4..5,8..9,11..12  ; 411
.shutter 0001100111000 4..5,8..10        ; 412
.shutter 0001100111010 4..5,8..10,12     ; 413
.shutter 0001100111100 4..5,8..11        ; 414
.shutter 0001100111110 4..5,8..12        ; 415
.shutter 0001101000000 4..5,7            ; 416
.shutter 0001101000010 4..5,7,12         ; 417
.shutter 0001101000100 4..5,7,11         ; 418
.shutter 0001101000110 4..5,7,11..12     ; 419
.shutter 0001101001000 4..5,7,10         ; 420
.shutter 0001101001010 4..5,7,10,12      ; 421
.shutter 0001101001100 4..5,7,10..11     ; 422
.shutter 0001101001110 4..5,7,10..12     ; 423
.shutter 0001101010000 4..5,7,9          ; 424
.shutter 0001101010010 4..5,7,9,12       ; 425
.shutter 0001101010100 4..5,7,9,11       ; 426
.shutter 0001101010110 4..5,7,9,11..12   ; 427
.shutter 0001101011000 4..5,7,9..10      ; 428
.shutter 0001101011010 4..5,7,9..10,12   ; 429
.shutter 0001101011100 4..5,7,9..11      ; 430
.shutter 0001101011110 4..5,7,9..12      ; 431
.shutter 0001101100000 4..5,7..8         ; 432
.shutter 0001101100010 4..5,7..8,12      ; 433
.shutter 0001101100100 4..5,7..8,11      ; 434
.shutter 0001101100110 4..5,7..8,11..12  ; 435
.shutter 0001101101000 4..5,7..8,10      ; 436
.shutter 0001101101010 4..5,7..8,10,12   ; 437
.shutter 0001101101100 4..5,7..8,10..11  ; 438
.shutter 0001101101110 4..5,7..8,10..12  ; 439
.shutter 0001101110000 4..5,7..9         ; 440
.shutter 0001101110010 4..5,7..9,12      ; 441
.shutter 0001101110100 4..5,7..9,11      ; 442
.shutter 0001101110110 4..5,7..9,11..12  ; 443
.shutter 0001101111000 4..5,7..10        ; 444
.shutter 0001101111010 4..5,7..10,12     ; 445
.shutter 0001101111100 4..5,7..11        ; 446
.shutter 0001101111110 4..5,7..12        ; 447
.shutter 0001110000000 4..6              ; 448
.shutter 0001110000010 4..6,12           ; 449
.shutter 0001110000100 4..6,11           ; 450
.shutter 0001110000110 4..6,11..12       ; 451
.shutter 0001110001000 4..6,10           ; 452
.shutter 0001110001010 4..6,10,12        ; 453
.shutter 0001110001100 4..6,10..11       ; 454
.shutter 0001110001110 4..6,10..12       ; 455
.shutter 0001110010000 4..6,9            ; 456
.shutter 0001110010010 4..6,9,12         ; 457
.shutter 0001110010100 4..6,9,11         ; 458
.shutter 0001110010110 4..6,9,11..12     ; 459
.shutter 0001110011000 4..6,9..10        ; 460
.shutter 0001110011010 4..6,9..10,12     ; 461
.shutter 0001110011100 4..6,9..11        ; 462
.shutter 0001110011110 4..6,9..12        ; 463
.shutter 0001110100000 4..6,8            ; 464
.shutter 0001110100010 4..6,8,12         ; 465
.shutter 0001110100100 4..6,8,11         ; 466
.shutter 0001110100110 4..6,8,11..12     ; 467
.shutter 0001110101000 4..6,8,10         ; 468
.shutter 0001110101010 4..6,8,10,12      ; 469
.shutter 0001110101100 4..6,8,10..11     ; 470
.shutter 0001110101110 4..6,8,10..12     ; 471
.shutter 0001110110000 4..6,8..9         ; 472
.shutter 0001110110010 4..6,8..9,12      ; 473
.shutter 0001110110100 4..6,8..9,11      ; 474
.shutter 0001110110110 4..6,8..9,11..12  ; 475
.shutter 0001110111000 4..6,8..10        ; 476
.shutter 0001110111010 4..6,8..10,12     ; 477
.shutter 0001110111100 4..6,8..11        ; 478
.shutter 0001110111110 4..6,8..12        ; 479
.shutter 0001111000000 4..7              ; 480
.shutter 0001111000010 4..7,12           ; 481
.shutter 0001111000100 4..7,11           ; 482
.shutter 0001111000110 4..7,11..12       ; 483
.shutter 0001111001000 4..7,10           ; 484
.shutter 0001111001010 4..7,10,12        ; 485
.shutter 0001111001100 4..7,10..11       ; 486
.shutter 0001111001110 4..7,10..12       ; 487
.shutter 0001111010000 4..7,9            ; 488
.shutter 0001111010010 4..7,9,12         ; 489
.shutter 0001111010100 4..7,9,11         ; 490
.shutter 0001111010110 4..7,9,11..12     ; 491
.shutter 0001111011000 4..7,9..10        ; 492
.shutter 0001111011010 4..7,9..10,12     ; 493
.shutter 0001111011100 4..7,9..11        ; 494
.shutter 0001111011110 4..7,9..12        ; 495
.shutter 0001111100000 4..8              ; 496
.shutter 0001111100010 4..8,12           ; 497
.shutter 0001111100100 4..8,11           ; 498
.shutter 0001111100110 4..8,11..12       ; 499
.shutter 0001111101000 4..8,10           ; 500
.shutter 0001111101010 4..8,10,12        ; 501
.shutter 0001111101100 4..8,10..11       ; 502
.shutter 0001111101110 4..8,10..12       ; 503
.shutter 0001111110000 4..9              ; 504
.shutter 0001111110010 4..9,12           ; 505
.shutter 0001111110100 4..9,11           ; 506
.shutter 0001111110110 4..9,11..12       ; 507
.shutter 0001111111000 4..10             ; 508
.shutter 0001111111010 4..10,12          ; 509
.shutter 0001111111100 4..11             ; 510
.shutter 0001111111110 4..12             ; 511
.shutter 0010000000000 3                 ; 512
.shutter 0010000000010 3,12              ; 513
.shutter 0010000000100 3,11              ; 514
.shutter 0010000000110 3,11..12          ; 515
.shutter 0010000001000 3,10              ; 516
.shutter 0010000001010 3,10,12           ; 517
.shutter 0010000001100 3,10..11          ; 518
.shutter 0010000001110 3,10..12          ; 519
.shutter 0010000010000 3,9               ; 520
.shutter 0010000010010 3,9,12            ; 521
.shutter 0010000010100 3,9,11            ; 522
.shutter 0010000010110 3,9,11..12        ; 523
.shutter 0010000011000 3,9..10           ; 524
.shutter 0010000011010 3,9..10,12        ; 525
.shutter 0010000011100 3,9..11           ; 526
.shutter 0010000011110 3,9..12           ; 527
.shutter 0010000100000 3,8               ; 528
.shutter 0010000100010 3,8,12            ; 529
.shutter 0010000100100 3,8,11            ; 530
.shutter 0010000100110 3,8,11..12        ; 531
.shutter 0010000101000 3,8,10            ; 532
.shutter 0010000101010 3,8,10,12         ; 533
.shutter 0010000101100 3,8,10..11        ; 534
.shutter 0010000101110 3,8,10..12        ; 535
.shutter 0010000110000 3,8..9            ; 536
.shutter 0010000110010 3,8..9,12         ; 537
.shutter 0010000110100 3,8..9,11         ; 538
.shutter 0010000110110 3,8..9,11..12     ; 539
.shutter 0010000111000 3,8..10           ; 540
.shutter 0010000111010 3,8..10,12        ; 541
.shutter 0010000111100 3,8..11           ; 542
.shutter 0010000111110 3,8..12           ; 543
.shutter 0010001000000 3,7               ; 544
.shutter 0010001000010 3,7,12            ; 545
.shutter 0010001000100 3,7,11            ; 546
.shutter 0010001000110 3,7,11..12        ; 547
.shutter 0010001001000 3,7,10            ; 548
.shutter 0010001001010 3,7,10,12         ; 549
.shutter 0010001001100 3,7,10..11        ; 550
.shutter 0010001001110 3,7,10..12        ; 551
.shutter 0010001010000 3,7,9             ; 552
.shutter 0010001010010 3,7,9,12          ; 553
.shutter 0010001010100 3,7,9,11          ; 554
.shutter 0010001010110 3,7,9,11..12      ; 555
.shutter 0010001011000 3,7,9..10         ; 556
.shutter 0010001011010 3,7,9..10,12      ; 557
.shutter 0010001011100 3,7,9..11         ; 558
.shutter 0010001011110 3,7,9..12         ; 559
.shutter 0010001100000 3,7..8            ; 560
.shutter 0010001100010 3,7..8,12         ; 561
.shutter 0010001100100 3,7..8,11         ; 562
.shutter 0010001100110 3,7..8,11..12     ; 563
.shutter 0010001101000 3,7..8,10         ; 564
.shutter 0010001101010 3,7..8,10,12      ; 565
.shutter 0010001101100 3,7..8,10..11     ; 566
.shutter 0010001101110 3,7..8,10..12     ; 567
.shutter 0010001110000 3,7..9            ; 568
.shutter 0010001110010 3,7..9,12         ; 569
.shutter 0010001110100 3,7..9,11         ; 570
.shutter 0010001110110 3,7..9,11..12     ; 571
.shutter 0010001111000 3,7..10           ; 572
.shutter 0010001111010 3,7..10,12        ; 573
.shutter 0010001111100 3,7..11           ; 574
.shutter 0010001111110 3,7..12           ; 575
.shutter 0010010000000 3,6               ; 576
.shutter 0010010000010 3,6,12            ; 577
.shutter 0010010000100 3,6,11            ; 578
.shutter 0010010000110 3,6,11..12        ; 579
.shutter 0010010001000 3,6,10            ; 580
.shutter 0010010001010 3,6,10,12         ; 581
.shutter 0010010001100 3,6,10..11        ; 582
.shutter 0010010001110 3,6,10..12        ; 583
.shutter 0010010010000 3,6,9             ; 584
.shutter 0010010010010 3,6,9,12          ; 585
.shutter 0010010010100 3,6,9,11          ; 586
.shutter 0010010010110 3,6,9,11..12      ; 587
.shutter 0010010011000 3,6,9..10         ; 588
.shutter 0010010011010 3,6,9..10,12      ; 589
.shutter 0010010011100 3,6,9..11         ; 590
.shutter 0010010011110 3,6,9..12         ; 591
.shutter 0010010100000 3,6,8             ; 592
.shutter 0010010100010 3,6,8,12          ; 593
.shutter 0010010100100 3,6,8,11          ; 594
.shutter 0010010100110 3,6,8,11..12      ; 595
.shutter 0010010101000 3,6,8,10          ; 596
.shutter 0010010101010 3,6..12/2         ; 597
.shutter 0010010101100 3,6,8,10..11      ; 598
.shutter 0010010101110 3,6,8,10..12      ; 599
.shutter 0010010110000 3,6,8..9          ; 600
.shutter 0010010110010 3,6,8..9,12       ; 601
.shutter 0010010110100 3,6,8..9,11       ; 602
.shutter 0010010110110 3,6,8..9,11..12   ; 603
.shutter 0010010111000 3,6,8..10         ; 604
.shutter 0010010111010 3,6,8..10,12      ; 605
.shutter 0010010111100 3,6,8..11         ; 606
.shutter 0010010111110 3,6,8..12         ; 607
.shutter 0010011000000 3,6..7            ; 608
.shutter 0010011000010 3,6..7,12         ; 609
.shutter 0010011000100 3,6..7,11         ; 610
.shutter 0010011000110 3,6..7,11..12     ; 611
.shutter 0010011001000 3,6..7,10         ; 612
.shutter 0010011001010 3,6..7,10,12      ; 613
.shutter 0010011001100 3,6..7,10..11     ; 614
.shutter 0010011001110 3,6..7,10..12     ; 615
.shutter 0010011010000 3,6..7,9          ; 616
.shutter 0010011010010 3,6..7,9,12       ; 617
.shutter 0010011010100 3,6..7,9,11       ; 618
.shutter 0010011010110 3,6..7,9,11..12   ; 619
.shutter 0010011011000 3,6..7,9..10      ; 620
.shutter 0010011011010 3,6..7,9..10,12   ; 621
.shutter 0010011011100 3,6..7,9..11      ; 622
.shutter 0010011011110 3,6..7,9..12      ; 623
.shutter 0010011100000 3,6..8            ; 624
.shutter 0010011100010 3,6..8,12         ; 625
.shutter 0010011100100 3,6..8,11         ; 626
.shutter 0010011100110 3,6..8,11..12     ; 627
.shutter 0010011101000 3,6..8,10         ; 628
.shutter 0010011101010 3,6..8,10,12      ; 629
.shutter 0010011101100 3,6..8,10..11     ; 630
.shutter 0010011101110 3,6..8,10..12     ; 631
.shutter 0010011110000 3,6..9            ; 632
.shutter 0010011110010 3,6..9,12         ; 633
.shutter 0010011110100 3,6..9,11         ; 634
.shutter 0010011110110 3,6..9,11..12     ; 635
.shutter 0010011111000 3,6..10           ; 636
.shutter 0010011111010 3,6..10,12        ; 637
.shutter 0010011111100 3,6..11           ; 638
.shutter 0010011111110 3,6..12           ; 639
.shutter 0010100000000 3,5               ; 640
.shutter 0010100000010 3,5,12            ; 641
.shutter 0010100000100 3,5,11            ; 642
.shutter 0010100000110 3,5,11..12        ; 643
.shutter 0010100001000 3,5,10            ; 644
.shutter 0010100001010 3,5,10,12         ; 645
.shutter 0010100001100 3,5,10..11        ; 646
.shutter 0010100001110 3,5,10..12        ; 647
.shutter 0010100010000 3,5,9             ; 648
.shutter 0010100010010 3,5,9,12          ; 649
.shutter 0010100010100 3,5,9,11          ; 650
.shutter 0010100010110 3,5,9,11..12      ; 651
.shutter 0010100011000 3,5,9..10         ; 652
.shutter 0010100011010 3,5,9..10,12      ; 653
.shutter 0010100011100 3,5,9..11         ; 654
.shutter 0010100011110 3,5,9..12         ; 655
.shutter 0010100100000 3,5,8             ; 656
.shutter 0010100100010 3,5,8,12          ; 657
.shutter 0010100100100 3,5,8,11          ; 658
.shutter 0010100100110 3,5,8,11..12      ; 659
.shutter 0010100101000 3,5,8,10          ; 660
.shutter 0010100101010 3,5,8..12/2       ; 661
.shutter 0010100101100 3,5,8,10..11      ; 662
.shutter 0010100101110 3,5,8,10..12      ; 663
.shutter 0010100110000 3,5,8..9          ; 664
.shutter 0010100110010 3,5,8..9,12       ; 665
.shutter 0010100110100 3,5,8..9,11       ; 666
.shutter 0010100110110 3,5,8..9,11..12   ; 667
.shutter 0010100111000 3,5,8..10         ; 668
.shutter 0010100111010 3,5,8..10,12      ; 669
.shutter 0010100111100 3,5,8..11         ; 670
.shutter 0010100111110 3,5,8..12         ; 671
.shutter 0010101000000 3,5,7             ; 672
.shutter 0010101000010 3,5,7,12          ; 673
.shutter 0010101000100 3,5,7,11          ; 674
.shutter 0010101000110 3,5,7,11..12      ; 675
.shutter 0010101001000 3,5,7,10          ; 676
.shutter 0010101001010 3..7/2,10,12      ; 677
.shutter 0010101001100 3,5,7,10..11      ; 678
.shutter 0010101001110 3,5,7,10..12      ; 679
.shutter 0010101010000 3,5,7,9           ; 680
.shutter 0010101010010 3..9/2,12         ; 681
.shutter 0010101010100 3..11/2           ; 682
.shutter 0010101010110 3..11/2,12        ; 683
.shutter 0010101011000 3,5,7,9..10       ; 684
.shutter 0010101011010 3..9/2,10,12      ; 685
.shutter 0010101011100 3,5,7,9..11       ; 686
.shutter 0010101011110 3,5,7,9..12       ; 687
.shutter 0010101100000 3,5,7..8          ; 688
.shutter 0010101100010 3,5,7..8,12       ; 689
.shutter 0010101100100 3,5,7..8,11       ; 690
.shutter 0010101100110 3,5,7..8,11..12   ; 691
.shutter 0010101101000 3,5,7..8,10       ; 692
.shutter 0010101101010 3..7/2,8..12/2    ; 693
.shutter 0010101101100 3,5,7..8,10..11   ; 694
.shutter 0010101101110 3,5,7..8,10..12   ; 695
.shutter 0010101110000 3,5,7..9          ; 696
.shutter 0010101110010 3,5,7..9,12       ; 697
.shutter 0010101110100 3,5,7..9,11       ; 698
.shutter 0010101110110 3,5,7..9,11..12   ; 699
.shutter 0010101111000 3,5,7..10         ; 700
.shutter 0010101111010 3,5,7..10,12      ; 701
.shutter 0010101111100 3,5,7..11         ; 702
.shutter 0010101111110 3,5,7..12         ; 703
.shutter 0010110000000 3,5..6            ; 704
.shutter 0010110000010 3,5..6,12         ; 705
.shutter 0010110000100 3,5..6,11         ; 706
.shutter 0010110000110 3,5..6,11..12     ; 707
.shutter 0010110001000 3,5..6,10         ; 708
.shutter 0010110001010 3,5..6,10,12      ; 709
.shutter 0010110001100 3,5..6,10..11     ; 710
.shutter 0010110001110 3,5..6,10..12     ; 711
.shutter 0010110010000 3,5..6,9          ; 712
.shutter 0010110010010 3,5..6,9,12       ; 713
.shutter 0010110010100 3,5..6,9,11       ; 714
.shutter 0010110010110 3,5..6,9,11..12   ; 715
.shutter 0010110011000 3,5..6,9..10      ; 716
.shutter 0010110011010 3,5..6,9..10,12   ; 717
.shutter 0010110011100 3,5..6,9..11      ; 718
.shutter 0010110011110 3,5..6,9..12      ; 719
.shutter 0010110100000 3,5..6,8          ; 720
.shutter 0010110100010 3,5..6,8,12       ; 721
.shutter 0010110100100 3,5..6,8,11       ; 722
.shutter 0010110100110 3,5..6,8,11..12   ; 723
.shutter 0010110101000 3,5..6,8,10       ; 724
.shutter 0010110101010 3,5..6,8..12/2    ; 725
.shutter 0010110101100 3,5..6,8,10..11   ; 726
.shutter 0010110101110 3,5..6,8,10..12   ; 727
.shutter 0010110110000 3,5..6,8..9       ; 728
.shutter 0010110110010 3,5..6,8..9,12    ; 729
.shutter 0010110110100 3,5..6,8..9,11    ; 730
.shutter 0010110110110 3,5..6,8..9,11..12 ; 731
.shutter 0010110111000 3,5..6,8..10      ; 732
.shutter 0010110111010 3,5..6,8..10,12   ; 733
.shutter 0010110111100 3,5..6,8..11      ; 734
.shutter 0010110111110 3,5..6,8..12      ; 735
.shutter 0010111000000 3,5..7            ; 736
.shutter 0010111000010 3,5..7,12         ; 737
.shutter 0010111000100 3,5..7,11         ; 738
.shutter 0010111000110 3,5..7,11..12     ; 739
.shutter 0010111001000 3,5..7,10         ; 740
.shutter 0010111001010 3,5..7,10,12      ; 741
.shutter 0010111001100 3,5..7,10..11     ; 742
.shutter 0010111001110 3,5..7,10..12     ; 743
.shutter 0010111010000 3,5..7,9          ; 744
.shutter 0010111010010 3,5..7,9,12       ; 745
.shutter 0010111010100 3,5..7,9,11       ; 746
.shutter 0010111010110 3,5..7,9,11..12   ; 747
.shutter 0010111011000 3,5..7,9..10      ; 748
.shutter 0010111011010 3,5..7,9..10,12   ; 749
.shutter 0010111011100 3,5..7,9..11      ; 750
.shutter 0010111011110 3,5..7,9..12      ; 751
.shutter 0010111100000 3,5..8            ; 752
.shutter 0010111100010 3,5..8,12         ; 753
.shutter 0010111100100 3,5..8,11         ; 754
.shutter 0010111100110 3,5..8,11..12     ; 755
.shutter 0010111101000 3,5..8,10         ; 756
.shutter 0010111101010 3,5..8,10,12      ; 757
.shutter 0010111101100 3,5..8,10..11     ; 758
.shutter 0010111101110 3,5..8,10..12     ; 759
.shutter 0010111110000 3,5..9            ; 760
.shutter 0010111110010 3,5..9,12         ; 761
.shutter 0010111110100 3,5..9,11         ; 762
.shutter 0010111110110 3,5..9,11..12     ; 763
.shutter 0010111111000 3,5..10           ; 764
.shutter 0010111111010 3,5..10,12        ; 765
.shutter 0010111111100 3,5..11           ; 766
.shutter 0010111111110 3,5..12           ; 767
.shutter 0011000000000 3..4              ; 768
.shutter 0011000000010 3..4,12           ; 769
.shutter 0011000000100 3..4,11           ; 770
.shutter 0011000000110 3..4,11..12       ; 771
.shutter 0011000001000 3..4,10           ; 772
.shutter 0011000001010 3..4,10,12        ; 773
.shutter 0011000001100 3..4,10..11       ; 774
.shutter 0011000001110 3..4,10..12       ; 775
.shutter 0011000010000 3..4,9            ; 776
.shutter 0011000010010 3..4,9,12         ; 777
.shutter 0011000010100 3..4,9,11         ; 778
.shutter 0011000010110 3..4,9,11..12     ; 779
.shutter 0011000011000 3..4,9..10        ; 780
.shutter 0011000011010 3..4,9..10,12     ; 781
.shutter 0011000011100 3..4,9..11        ; 782
.shutter 0011000011110 3..4,9..12        ; 783
.shutter 0011000100000 3..4,8            ; 784
.shutter 0011000100010 3..4,8,12         ; 785
.shutter 0011000100100 3..4,8,11         ; 786
.shutter 0011000100110 3..4,8,11..12     ; 787
.shutter 0011000101000 3..4,8,10         ; 788
.shutter 0011000101010 3..4,8,10,12      ; 789
.shutter 0011000101100 3..4,8,10..11     ; 790
.shutter 0011000101110 3..4,8,10..12     ; 791
.shutter 0011000110000 3..4,8..9         ; 792
.shutter 0011000110010 3..4,8..9,12      ; 793
.shutter 0011000110100 3..4,8..9,11      ; 794
.shutter 0011000110110 3..4,8..9,11..12  ; 795
.shutter 0011000111000 3..4,8..10        ; 796
.shutter 0011000111010 3..4,8..10,12     ; 797
.shutter 0011000111100 3..4,8..11        ; 798
.shutter 0011000111110 3..4,8..12        ; 799
.shutter 0011001000000 3..4,7            ; 800
.shutter 0011001000010 3..4,7,12         ; 801
.shutter 0011001000100 3..4,7,11         ; 802
.shutter 0011001000110 3..4,7,11..12     ; 803
.shutter 0011001001000 3..4,7,10         ; 804
.shutter 0011001001010 3..4,7,10,12      ; 805
.shutter 0011001001100 3..4,7,10..11     ; 806
.shutter 0011001001110 3..4,7,10..12     ; 807
.shutter 0011001010000 3..4,7,9          ; 808
.shutter 0011001010010 3..4,7,9,12       ; 809
.shutter 0011001010100 3..4,7,9,11       ; 810
.shutter 0011001010110 3..4,7,9,11..12   ; 811
.shutter 0011001011000 3..4,7,9..10      ; 812
.shutter 0011001011010 3..4,7,9..10,12   ; 813
.shutter 0011001011100 3..4,7,9..11      ; 814
.shutter 0011001011110 3..4,7,9..12      ; 815
.shutter 0011001100000 3..4,7..8         ; 816
.shutter 0011001100010 3..4,7..8,12      ; 817
.shutter 0011001100100 3..4,7..8,11      ; 818
.shutter 0011001100110 3..4,7..8,11..12  ; 819
.shutter 0011001101000 3..4,7..8,10      ; 820
.shutter 0011001101010 3..4,7..8,10,12   ; 821
.shutter 0011001101100 3..4,7..8,10..11  ; 822
.shutter 0011001101110 3..4,7..8,10..12  ; 823
.shutter 0011001110000 3..4,7..9         ; 824
.shutter 0011001110010 3..4,7..9,12      ; 825
.shutter 0011001110100 3..4,7..9,11      ; 826
.shutter 0011001110110 3..4,7..9,11..12  ; 827
.shutter 0011001111000 3..4,7..10        ; 828
.shutter 0011001111010 3..4,7..10,12     ; 829
.shutter 0011001111100 3..4,7..11        ; 830
.shutter 0011001111110 3..4,7..12        ; 831
.shutter 0011010000000 3..4,6            ; 832
.shutter 0011010000010 3..4,6,12         ; 833
.shutter 0011010000100 3..4,6,11         ; 834
.shutter 0011010000110 3..4,6,11..12     ; 835
.shutter 0011010001000 3..4,6,10         ; 836
.shutter 0011010001010 3..4,6,10,12      ; 837
.shutter 0011010001100 3..4,6,10..11     ; 838
.shutter 0011010001110 3..4,6,10..12     ; 839
.shutter 0011010010000 3..4,6,9          ; 840
.shutter 0011010010010 3..4,6,9,12       ; 841
.shutter 0011010010100 3..4,6,9,11       ; 842
.shutter 0011010010110 3..4,6,9,11..12   ; 843
.shutter 0011010011000 3..4,6,9..10      ; 844
.shutter 0011010011010 3..4,6,9..10,12   ; 845
.shutter 0011010011100 3..4,6,9..11      ; 846
.shutter 0011010011110 3..4,6,9..12      ; 847
.shutter 0011010100000 3..4,6,8          ; 848
.shutter 0011010100010 3..4,6,8,12       ; 849
.shutter 0011010100100 3..4,6,8,11       ; 850
.shutter 0011010100110 3..4,6,8,11..12   ; 851
.shutter 0011010101000 3..4,6,8,10       ; 852
.shutter 0011010101010 3..4,6..12/2      ; 853
.shutter 0011010101100 3..4,6,8,10..11   ; 854
.shutter 0011010101110 3..4,6,8,10..12   ; 855
.shutter 0011010110000 3..4,6,8..9       ; 856
.shutter 0011010110010 3..4,6,8..9,12    ; 857
.shutter 0011010110100 3..4,6,8..9,11    ; 858
.shutter 0011010110110 3..4,6,8..9,11..12 ; 859
.shutter 0011010111000 3..4,6,8..10      ; 860
.shutter 0011010111010 3..4,6,8..10,12   ; 861
.shutter 0011010111100 3..4,6,8..11      ; 862
.shutter 0011010111110 3..4,6,8..12      ; 863
.shutter 0011011000000 3..4,6..7         ; 864
.shutter 0011011000010 3..4,6..7,12      ; 865
.shutter 0011011000100 3..4,6..7,11      ; 866
.shutter 0011011000110 3..4,6..7,11..12  ; 867
.shutter 0011011001000 3..4,6..7,10      ; 868
.shutter 0011011001010 3..4,6..7,10,12   ; 869
.shutter 0011011001100 3..4,6..7,10..11  ; 870
.shutter 0011011001110 3..4,6..7,10..12  ; 871
.shutter 0011011010000 3..4,6..7,9       ; 872
.shutter 0011011010010 3..4,6..7,9,12    ; 873
.shutter 0011011010100 3..4,6..7,9,11    ; 874
.shutter 0011011010110 3..4,6..7,9,11..12 ; 875
.shutter 0011011011000 3..4,6..7,9..10   ; 876
.shutter 0011011011010 3..4,6..7,9..10,12 ; 877
.shutter 0011011011100 3..4,6..7,9..11   ; 878
.shutter 0011011011110 3..4,6..7,9..12   ; 879
.shutter 0011011100000 3..4,6..8         ; 880
.shutter 0011011100010 3..4,6..8,12      ; 881
.shutter 0011011100100 3..4,6..8,11      ; 882
.shutter 0011011100110 3..4,6..8,11..12  ; 883
.shutter 0011011101000 3..4,6..8,10      ; 884
.shutter 0011011101010 3..4,6..8,10,12   ; 885
.shutter 0011011101100 3..4,6..8,10..11  ; 886
.shutter 0011011101110 3..4,6..8,10..12  ; 887
.shutter 0011011110000 3..4,6..9         ; 888
.shutter 0011011110010 3..4,6..9,12      ; 889
.shutter 0011011110100 3..4,6..9,11      ; 890
.shutter 0011011110110 3..4,6..9,11..12  ; 891
.shutter 0011011111000 3..4,6..10        ; 892
.shutter 0011011111010 3..4,6..10,12     ; 893
.shutter 0011011111100 3..4,6..11        ; 894
.shutter 0011011111110 3..4,6..12        ; 895
.shutter 0011100000000 3..5              ; 896
.shutter 0011100000010 3..5,12           ; 897
.shutter 0011100000100 3..5,11           ; 898
.shutter 0011100000110 3..5,11..12       ; 899
.shutter 0011100001000 3..5,10           ; 900
.shutter 0011100001010 3..5,10,12        ; 901
.shutter 0011100001100 3..5,10..11       ; 902
.shutter 0011100001110 3..5,10..12       ; 903
.shutter 0011100010000 3..5,9            ; 904
.shutter 0011100010010 3..5,9,12         ; 905
.shutter 0011100010100 3..5,9,11         ; 906
.shutter 0011100010110 3..5,9,11..12     ; 907
.shutter 0011100011000 3..5,9..10        ; 908
.shutter 0011100011010 3..5,9..10,12     ; 909
.shutter 0011100011100 3..5,9..11        ; 910
.shutter 0011100011110 3..5,9..12        ; 911
.shutter 0011100100000 3..5,8            ; 912
.shutter 0011100100010 3..5,8,12         ; 913
.shutter 0011100100100 3..5,8,11         ; 914
.shutter 0011100100110 3..5,8,11..12     ; 915
.shutter 0011100101000 3..5,8,10         ; 916
.shutter 0011100101010 3..5,8,10,12      ; 917
.shutter 0011100101100 3..5,8,10..11     ; 918
.shutter 0011100101110 3..5,8,10..12     ; 919
.shutter 0011100110000 3..5,8..9         ; 920
.shutter 0011100110010 3..5,8..9,12      ; 921
.shutter 0011100110100 3..5,8..9,11      ; 922
.shutter 0011100110110 3..5,8..9,11..12  ; 923
.shutter 0011100111000 3..5,8..10        ; 924
.shutter 0011100111010 3..5,8..10,12     ; 925
.shutter 0011100111100 3..5,8..11        ; 926
.shutter 0011100111110 3..5,8..12        ; 927
.shutter 0011101000000 3..5,7            ; 928
.shutter 0011101000010 3..5,7,12         ; 929
.shutter 0011101000100 3..5,7,11         ; 930
.shutter 0011101000110 3..5,7,11..12     ; 931
.shutter 0011101001000 3..5,7,10         ; 932
.shutter 0011101001010 3..5,7,10,12      ; 933
.shutter 0011101001100 3..5,7,10..11     ; 934
.shutter 0011101001110 3..5,7,10..12     ; 935
.shutter 0011101010000 3..5,7,9          ; 936
.shutter 0011101010010 3..5,7,9,12       ; 937
.shutter 0011101010100 3..5,7,9,11       ; 938
.shutter 0011101010110 3..5,7,9,11..12   ; 939
.shutter 0011101011000 3..5,7,9..10      ; 940
.shutter 0011101011010 3..5,7,9..10,12   ; 941
.shutter 0011101011100 3..5,7,9..11      ; 942
.shutter 0011101011110 3..5,7,9..12      ; 943
.shutter 0011101100000 3..5,7..8         ; 944
.shutter 0011101100010 3..5,7..8,12      ; 945
.shutter 0011101100100 3..5,7..8,11      ; 946
.shutter 0011101100110 3..5,7..8,11..12  ; 947
.shutter 0011101101000 3..5,7..8,10      ; 948
.shutter 0011101101010 3..5,7..8,10,12   ; 949
.shutter 0011101101100 3..5,7..8,10..11  ; 950
.shutter 0011101101110 3..5,7..8,10..12  ; 951
.shutter 0011101110000 3..5,7..9         ; 952
.shutter 0011101110010 3..5,7..9,12      ; 953
.shutter 0011101110100 3..5,7..9,11      ; 954
.shutter 0011101110110 3..5,7..9,11..12  ; 955
.shutter 0011101111000 3..5,7..10        ; 956
.shutter 0011101111010 3..5,7..10,12     ; 957
.shutter 0011101111100 3..5,7..11        ; 958
.shutter 0011101111110 3..5,7..12        ; 959
.shutter 0011110000000 3..6              ; 960
.shutter 0011110000010 3..6,12           ; 961
.shutter 0011110000100 3..6,11           ; 962
.shutter 0011110000110 3..6,11..12       ; 963
.shutter 0011110001000 3..6,10           ; 964
.shutter 0011110001010 3..6,10,12        ; 965
.shutter 0011110001100 3..6,10..11       ; 966
.shutter 0011110001110 3..6,10..12       ; 967
.shutter 0011110010000 3..6,9            ; 968
.shutter 0011110010010 3..6,9,12         ; 969
.shutter 0011110010100 3..6,9,11         ; 970
.shutter 0011110010110 3..6,9,11..12     ; 971
.shutter 0011110011000 3..6,9..10        ; 972
.shutter 0011110011010 3..6,9..10,12     ; 973
.shutter 0011110011100 3..6,9..11        ; 974
.shutter 0011110011110 3..6,9..12        ; 975
.shutter 0011110100000 3..6,8            ; 976
.shutter 0011110100010 3..6,8,12         ; 977
.shutter 0011110100100 3..6,8,11         ; 978
.shutter 0011110100110 3..6,8,11..12     ; 979
.shutter 0011110101000 3..6,8,10         ; 980
.shutter 0011110101010 3..6,8,10,12      ; 981
.shutter 0011110101100 3..6,8,10..11     ; 982
.shutter 0011110101110 3..6,8,10..12     ; 983
.shutter 0011110110000 3..6,8..9         ; 984
.shutter 0011110110010 3..6,8..9,12      ; 985
.shutter 0011110110100 3..6,8..9,11      ; 986
.shutter 0011110110110 3..6,8..9,11..12  ; 987
.shutter 0011110111000 3..6,8..10        ; 988
.shutter 0011110111010 3..6,8..10,12     ; 989
.shutter 0011110111100 3..6,8..11        ; 990
.shutter 0011110111110 3..6,8..12        ; 991
.shutter 0011111000000 3..7              ; 992
.shutter 0011111000010 3..7,12           ; 993
.shutter 0011111000100 3..7,11           ; 994
.shutter 0011111000110 3..7,11..12       ; 995
.shutter 0011111001000 3..7,10           ; 996
.shutter 0011111001010 3..7,10,12        ; 997
.shutter 0011111001100 3..7,10..11       ; 998
.shutter 0011111001110 3..7,10..12       ; 999
.shutter 0011111010000 3..7,9            ; 1000
.shutter 0011111010010 3..7,9,12         ; 1001
.shutter 0011111010100 3..7,9,11         ; 1002
.shutter 0011111010110 3..7,9,11..12     ; 1003
.shutter 0011111011000 3..7,9..10        ; 1004
.shutter 0011111011010 3..7,9..10,12     ; 1005
.shutter 0011111011100 3..7,9..11        ; 1006
.shutter 0011111011110 3..7,9..12        ; 1007
.shutter 0011111100000 3..8              ; 1008
.shutter 0011111100010 3..8,12           ; 1009
.shutter 0011111100100 3..8,11           ; 1010
.shutter 0011111100110 3..8,11..12       ; 1011
.shutter 0011111101000 3..8,10           ; 1012
.shutter 0011111101010 3..8,10,12        ; 1013
.shutter 0011111101100 3..8,10..11       ; 1014
.shutter 0011111101110 3..8,10..12       ; 1015
.shutter 0011111110000 3..9              ; 1016
.shutter 0011111110010 3..9,12           ; 1017
.shutter 0011111110100 3..9,11           ; 1018
.shutter 0011111110110 3..9,11..12       ; 1019
.shutter 0011111111000 3..10             ; 1020
.shutter 0011111111010 3..10,12          ; 1021
.shutter 0011111111100 3..11             ; 1022
.shutter 0011111111110 3..12             ; 1023
.shutter 0100000000000 2                 ; 1024
.shutter 0100000000010 2,12              ; 1025
.shutter 0100000000100 2,11              ; 1026
.shutter 0100000000110 2,11..12          ; 1027
.shutter 0100000001000 2,10              ; 1028
.shutter 0100000001010 2,10,12           ; 1029
.shutter 0100000001100 2,10..11          ; 1030
.shutter 0100000001110 2,10..12          ; 1031
.shutter 0100000010000 2,9               ; 1032
.shutter 0100000010010 2,9,12            ; 1033
.shutter 0100000010100 2,9,11            ; 1034
.shutter 0100000010110 2,9,11..12        ; 1035
.shutter 0100000011000 2,9..10           ; 1036
.shutter 0100000011010 2,9..10,12        ; 1037
.shutter 0100000011100 2,9..11           ; 1038
.shutter 0100000011110 2,9..12           ; 1039
.shutter 0100000100000 2,8               ; 1040
.shutter 0100000100010 2,8,12            ; 1041
.shutter 0100000100100 2,8,11            ; 1042
.shutter 0100000100110 2,8,11..12        ; 1043
.shutter 0100000101000 2,8,10            ; 1044
.shutter 0100000101010 2,8,10,12         ; 1045
.shutter 0100000101100 2,8,10..11        ; 1046
.shutter 0100000101110 2,8,10..12        ; 1047
.shutter 0100000110000 2,8..9            ; 1048
.shutter 0100000110010 2,8..9,12         ; 1049
.shutter 0100000110100 2,8..9,11         ; 1050
.shutter 0100000110110 2,8..9,11..12     ; 1051
.shutter 0100000111000 2,8..10           ; 1052
.shutter 0100000111010 2,8..10,12        ; 1053
.shutter 0100000111100 2,8..11           ; 1054
.shutter 0100000111110 2,8..12           ; 1055
.shutter 0100001000000 2,7               ; 1056
.shutter 0100001000010 2,7,12            ; 1057
.shutter 0100001000100 2,7,11            ; 1058
.shutter 0100001000110 2,7,11..12        ; 1059
.shutter 0100001001000 2,7,10            ; 1060
.shutter 0100001001010 2,7,10,12         ; 1061
.shutter 0100001001100 2,7,10..11        ; 1062
.shutter 0100001001110 2,7,10..12        ; 1063
.shutter 0100001010000 2,7,9             ; 1064
.shutter 0100001010010 2,7,9,12          ; 1065
.shutter 0100001010100 2,7,9,11          ; 1066
.shutter 0100001010110 2,7,9,11..12      ; 1067
.shutter 0100001011000 2,7,9..10         ; 1068
.shutter 0100001011010 2,7,9..10,12      ; 1069
.shutter 0100001011100 2,7,9..11         ; 1070
.shutter 0100001011110 2,7,9..12         ; 1071
.shutter 0100001100000 2,7..8            ; 1072
.shutter 0100001100010 2,7..8,12         ; 1073
.shutter 0100001100100 2,7..8,11         ; 1074
.shutter 0100001100110 2,7..8,11..12     ; 1075
.shutter 0100001101000 2,7..8,10         ; 1076
.shutter 0100001101010 2,7..8,10,12      ; 1077
.shutter 0100001101100 2,7..8,10..11     ; 1078
.shutter 0100001101110 2,7..8,10..12     ; 1079
.shutter 0100001110000 2,7..9            ; 1080
.shutter 0100001110010 2,7..9,12         ; 1081
.shutter 0100001110100 2,7..9,11         ; 1082
.shutter 0100001110110 2,7..9,11..12     ; 1083
.shutter 0100001111000 2,7..10           ; 1084
.shutter 0100001111010 2,7..10,12        ; 1085
.shutter 0100001111100 2,7..11           ; 1086
.shutter 0100001111110 2,7..12           ; 1087
.shutter 0100010000000 2,6               ; 1088
.shutter 0100010000010 2,6,12            ; 1089
.shutter 0100010000100 2,6,11            ; 1090
.shutter 0100010000110 2,6,11..12        ; 1091
.shutter 0100010001000 2,6,10            ; 1092
.shutter 0100010001010 2,6,10,12         ; 1093
.shutter 0100010001100 2,6,10..11        ; 1094
.shutter 0100010001110 2,6,10..12        ; 1095
.shutter 0100010010000 2,6,9             ; 1096
.shutter 0100010010010 2,6,9,12          ; 1097
.shutter 0100010010100 2,6,9,11          ; 1098
.shutter 0100010010110 2,6,9,11..12      ; 1099
.shutter 0100010011000 2,6,9..10         ; 1100
.shutter 0100010011010 2,6,9..10,12      ; 1101
.shutter 0100010011100 2,6,9..11         ; 1102
.shutter 0100010011110 2,6,9..12         ; 1103
.shutter 0100010100000 2,6,8             ; 1104
.shutter 0100010100010 2,6,8,12          ; 1105
.shutter 0100010100100 2,6,8,11          ; 1106
.shutter 0100010100110 2,6,8,11..12      ; 1107
.shutter 0100010101000 2,6,8,10          ; 1108
.shutter 0100010101010 2,6..12/2         ; 1109
.shutter 0100010101100 2,6,8,10..11      ; 1110
.shutter 0100010101110 2,6,8,10..12      ; 1111
.shutter 0100010110000 2,6,8..9          ; 1112
.shutter 0100010110010 2,6,8..9,12       ; 1113
.shutter 0100010110100 2,6,8..9,11       ; 1114
.shutter 0100010110110 2,6,8..9,11..12   ; 1115
.shutter 0100010111000 2,6,8..10         ; 1116
.shutter 0100010111010 2,6,8..10,12      ; 1117
.shutter 0100010111100 2,6,8..11         ; 1118
.shutter 0100010111110 2,6,8..12         ; 1119
.shutter 0100011000000 2,6..7            ; 1120
.shutter 0100011000010 2,6..7,12         ; 1121
.shutter 0100011000100 2,6..7,11         ; 1122
.shutter 0100011000110 2,6..7,11..12     ; 1123
.shutter 0100011001000 2,6..7,10         ; 1124
.shutter 0100011001010 2,6..7,10,12      ; 1125
.shutter 0100011001100 2,6..7,10..11     ; 1126
.shutter 0100011001110 2,6..7,10..12     ; 1127
.shutter 0100011010000 2,6..7,9          ; 1128
.shutter 0100011010010 2,6..7,9,12       ; 1129
.shutter 0100011010100 2,6..7,9,11       ; 1130
.shutter 0100011010110 2,6..7,9,11..12   ; 1131
.shutter 0100011011000 2,6..7,9..10      ; 1132
.shutter 0100011011010 2,6..7,9..10,12   ; 1133
.shutter 0100011011100 2,6..7,9..11      ; 1134
.shutter 0100011011110 2,6..7,9..12      ; 1135
.shutter 0100011100000 2,6..8            ; 1136
.shutter 0100011100010 2,6..8,12         ; 1137
.shutter 0100011100100 2,6..8,11         ; 1138
.shutter 0100011100110 2,6..8,11..12     ; 1139
.shutter 0100011101000 2,6..8,10         ; 1140
.shutter 0100011101010 2,6..8,10,12      ; 1141
.shutter 0100011101100 2,6..8,10..11     ; 1142
.shutter 0100011101110 2,6..8,10..12     ; 1143
.shutter 0100011110000 2,6..9            ; 1144
.shutter 0100011110010 2,6..9,12         ; 1145
.shutter 0100011110100 2,6..9,11         ; 1146
.shutter 0100011110110 2,6..9,11..12     ; 1147
.shutter 0100011111000 2,6..10           ; 1148
.shutter 0100011111010 2,6..10,12        ; 1149
.shutter 0100011111100 2,6..11           ; 1150
.shutter 0100011111110 2,6..12           ; 1151
.shutter 0100100000000 2,5               ; 1152
.shutter 0100100000010 2,5,12            ; 1153
.shutter 0100100000100 2,5,11            ; 1154
.shutter 0100100000110 2,5,11..12        ; 1155
.shutter 0100100001000 2,5,10            ; 1156
.shutter 0100100001010 2,5,10,12         ; 1157
.shutter 0100100001100 2,5,10..11        ; 1158
.shutter 0100100001110 2,5,10..12        ; 1159
.shutter 0100100010000 2,5,9             ; 1160
.shutter 0100100010010 2,5,9,12          ; 1161
.shutter 0100100010100 2,5,9,11          ; 1162
.shutter 0100100010110 2,5,9,11..12      ; 1163
.shutter 0100100011000 2,5,9..10         ; 1164
.shutter 0100100011010 2,5,9..10,12      ; 1165
.shutter 0100100011100 2,5,9..11         ; 1166
.shutter 0100100011110 2,5,9..12         ; 1167
.shutter 0100100100000 2,5,8             ; 1168
.shutter 0100100100010 2,5,8,12          ; 1169
.shutter 0100100100100 2,5,8,11          ; 1170
.shutter 0100100100110 2,5,8,11..12      ; 1171
.shutter 0100100101000 2,5,8,10          ; 1172
.shutter 0100100101010 2..8/3,10,12      ; 1173
.shutter 0100100101100 2,5,8,10..11      ; 1174
.shutter 0100100101110 2,5,8,10..12      ; 1175
.shutter 0100100110000 2,5,8..9          ; 1176
.shutter 0100100110010 2,5,8..9,12       ; 1177
.shutter 0100100110100 2,5,8..9,11       ; 1178
.shutter 0100100110110 2,5,8..9,11..12   ; 1179
.shutter 0100100111000 2,5,8..10         ; 1180
.shutter 0100100111010 2,5,8..10,12      ; 1181
.shutter 0100100111100 2,5,8..11         ; 1182
.shutter 0100100111110 2,5,8..12         ; 1183
.shutter 0100101000000 2,5,7             ; 1184
.shutter 0100101000010 2,5,7,12          ; 1185
.shutter 0100101000100 2,5,7,11          ; 1186
.shutter 0100101000110 2,5,7,11..12      ; 1187
.shutter 0100101001000 2,5,7,10          ; 1188
.shutter 0100101001010 2,5,7,10,12       ; 1189
.shutter 0100101001100 2,5,7,10..11      ; 1190
.shutter 0100101001110 2,5,7,10..12      ; 1191
.shutter 0100101010000 2,5,7,9           ; 1192
.shutter 0100101010010 2,5..9/2,12       ; 1193
.shutter 0100101010100 2,5..11/2         ; 1194
.shutter 0100101010110 2,5..11/2,12      ; 1195
.shutter 0100101011000 2,5,7,9..10       ; 1196
.shutter 0100101011010 2,5..9/2,10,12    ; 1197
.shutter 0100101011100 2,5,7,9..11       ; 1198
.shutter 0100101011110 2,5,7,9..12       ; 1199
.shutter 0100101100000 2,5,7..8          ; 1200
.shutter 0100101100010 2,5,7..8,12       ; 1201
.shutter 0100101100100 2,5,7..8,11       ; 1202
.shutter 0100101100110 2,5,7..8,11..12   ; 1203
.shutter 0100101101000 2,5,7..8,10       ; 1204
.shutter 0100101101010 2,5,7..8,10,12    ; 1205
.shutter 0100101101100 2,5,7..8,10..11   ; 1206
.shutter 0100101101110 2,5,7..8,10..12   ; 1207
.shutter 0100101110000 2,5,7..9          ; 1208
.shutter 0100101110010 2,5,7..9,12       ; 1209
.shutter 0100101110100 2,5,7..9,11       ; 1210
.shutter 0100101110110 2,5,7..9,11..12   ; 1211
.shutter 0100101111000 2,5,7..10         ; 1212
.shutter 0100101111010 2,5,7..10,12      ; 1213
.shutter 0100101111100 2,5,7..11         ; 1214
.shutter 0100101111110 2,5,7..12         ; 1215
.shutter 0100110000000 2,5..6            ; 1216
.shutter 0100110000010 2,5..6,12         ; 1217
.shutter 0100110000100 2,5..6,11         ; 1218
.shutter 0100110000110 2,5..6,11..12     ; 1219
.shutter 0100110001000 2,5..6,10         ; 1220
.shutter 0100110001010 2,5..6,10,12      ; 1221
.shutter 0100110001100 2,5..6,10..11     ; 1222
.shutter 0100110001110 2,5..6,10..12     ; 1223
.shutter 0100110010000 2,5..6,9          ; 1224
.shutter 0100110010010 2,5..6,9,12       ; 1225
.shutter 0100110010100 2,5..6,9,11       ; 1226
.shutter 0100110010110 2,5..6,9,11..12   ; 1227
.shutter 0100110011000 2,5..6,9..10      ; 1228
.shutter 0100110011010 2,5..6,9..10,12   ; 1229
.shutter 0100110011100 2,5..6,9..11      ; 1230
.shutter 0100110011110 2,5..6,9..12      ; 1231
.shutter 0100110100000 2,5..6,8          ; 1232
.shutter 0100110100010 2,5..6,8,12       ; 1233
.shutter 0100110100100 2,5..6,8,11       ; 1234
.shutter 0100110100110 2,5..6,8,11..12   ; 1235
.shutter 0100110101000 2,5..6,8,10       ; 1236
.shutter 0100110101010 2,5..6,8..12/2    ; 1237
.shutter 0100110101100 2,5..6,8,10..11   ; 1238
.shutter 0100110101110 2,5..6,8,10..12   ; 1239
.shutter 0100110110000 2,5..6,8..9       ; 1240
.shutter 0100110110010 2,5..6,8..9,12    ; 1241
.shutter 0100110110100 2,5..6,8..9,11    ; 1242
.shutter 0100110110110 2,5..6,8..9,11..12 ; 1243
.shutter 0100110111000 2,5..6,8..10      ; 1244
.shutter 0100110111010 2,5..6,8..10,12   ; 1245
.shutter 0100110111100 2,5..6,8..11      ; 1246
.shutter 0100110111110 2,5..6,8..12      ; 1247
.shutter 0100111000000 2,5..7            ; 1248
.shutter 0100111000010 2,5..7,12         ; 1249
.shutter 0100111000100 2,5..7,11         ; 1250
.shutter 0100111000110 2,5..7,11..12     ; 1251
.shutter 0100111001000 2,5..7,10         ; 1252
.shutter 0100111001010 2,5..7,10,12      ; 1253
.shutter 0100111001100 2,5..7,10..11     ; 1254
.shutter 0100111001110 2,5..7,10..12     ; 1255
.shutter 0100111010000 2,5..7,9          ; 1256
.shutter 0100111010010 2,5..7,9,12       ; 1257
.shutter 0100111010100 2,5..7,9,11       ; 1258
.shutter 0100111010110 2,5..7,9,11..12   ; 1259
.shutter 0100111011000 2,5..7,9..10      ; 1260
.shutter 0100111011010 2,5..7,9..10,12   ; 1261
.shutter 0100111011100 2,5..7,9..11      ; 1262
.shutter 0100111011110 2,5..7,9..12      ; 1263
.shutter 0100111100000 2,5..8            ; 1264
.shutter 0100111100010 2,5..8,12         ; 1265
.shutter 0100111100100 2,5..8,11         ; 1266
.shutter 0100111100110 2,5..8,11..12     ; 1267
.shutter 0100111101000 2,5..8,10         ; 1268
.shutter 0100111101010 2,5..8,10,12      ; 1269
.shutter 0100111101100 2,5..8,10..11     ; 1270
.shutter 0100111101110 2,5..8,10..12     ; 1271
.shutter 0100111110000 2,5..9            ; 1272
.shutter 0100111110010 2,5..9,12         ; 1273
.shutter 0100111110100 2,5..9,11         ; 1274
.shutter 0100111110110 2,5..9,11..12     ; 1275
.shutter 0100111111000 2,5..10           ; 1276
.shutter 0100111111010 2,5..10,12        ; 1277
.shutter 0100111111100 2,5..11           ; 1278
.shutter 0100111111110 2,5..12           ; 1279
.shutter 0101000000000 2,4               ; 1280
.shutter 0101000000010 2,4,12            ; 1281
.shutter 0101000000100 2,4,11            ; 1282
.shutter 0101000000110 2,4,11..12        ; 1283
.shutter 0101000001000 2,4,10            ; 1284
.shutter 0101000001010 2,4,10,12         ; 1285
.shutter 0101000001100 2,4,10..11        ; 1286
.shutter 0101000001110 2,4,10..12        ; 1287
.shutter 0101000010000 2,4,9             ; 1288
.shutter 0101000010010 2,4,9,12          ; 1289
.shutter 0101000010100 2,4,9,11          ; 1290
.shutter 0101000010110 2,4,9,11..12      ; 1291
.shutter 0101000011000 2,4,9..10         ; 1292
.shutter 0101000011010 2,4,9..10,12      ; 1293
.shutter 0101000011100 2,4,9..11         ; 1294
.shutter 0101000011110 2,4,9..12         ; 1295
.shutter 0101000100000 2,4,8             ; 1296
.shutter 0101000100010 2,4,8,12          ; 1297
.shutter 0101000100100 2,4,8,11          ; 1298
.shutter 0101000100110 2,4,8,11..12      ; 1299
.shutter 0101000101000 2,4,8,10          ; 1300
.shutter 0101000101010 2,4,8..12/2       ; 1301
.shutter 0101000101100 2,4,8,10..11      ; 1302
.shutter 0101000101110 2,4,8,10..12      ; 1303
.shutter 0101000110000 2,4,8..9          ; 1304
.shutter 0101000110010 2,4,8..9,12       ; 1305
.shutter 0101000110100 2,4,8..9,11       ; 1306
.shutter 0101000110110 2,4,8..9,11..12   ; 1307
.shutter 0101000111000 2,4,8..10         ; 1308
.shutter 0101000111010 2,4,8..10,12      ; 1309
.shutter 0101000111100 2,4,8..11         ; 1310
.shutter 0101000111110 2,4,8..12         ; 1311
.shutter 0101001000000 2,4,7             ; 1312
.shutter 0101001000010 2,4,7,12          ; 1313
.shutter 0101001000100 2,4,7,11          ; 1314
.shutter 0101001000110 2,4,7,11..12      ; 1315
.shutter 0101001001000 2,4,7,10          ; 1316
.shutter 0101001001010 2,4..10/3,12      ; 1317
.shutter 0101001001100 2,4,7,10..11      ; 1318
.shutter 0101001001110 2,4,7,10..12      ; 1319
.shutter 0101001010000 2,4,7,9           ; 1320
.shutter 0101001010010 2,4,7,9,12        ; 1321
.shutter 0101001010100 2,4,7..11/2       ; 1322
.shutter 0101001010110 2,4,7..11/2,12    ; 1323
.shutter 0101001011000 2,4,7,9..10       ; 1324
.shutter 0101001011010 2,4,7,9..10,12    ; 1325
.shutter 0101001011100 2,4,7,9..11       ; 1326
.shutter 0101001011110 2,4,7,9..12       ; 1327
.shutter 0101001100000 2,4,7..8          ; 1328
.shutter 0101001100010 2,4,7..8,12       ; 1329
.shutter 0101001100100 2,4,7..8,11       ; 1330
.shutter 0101001100110 2,4,7..8,11..12   ; 1331
.shutter 0101001101000 2,4,7..8,10       ; 1332
.shutter 0101001101010 2,4,7..8,10,12    ; 1333
.shutter 0101001101100 2,4,7..8,10..11   ; 1334
.shutter 0101001101110 2,4,7..8,10..12   ; 1335
.shutter 0101001110000 2,4,7..9          ; 1336
.shutter 0101001110010 2,4,7..9,12       ; 1337
.shutter 0101001110100 2,4,7..9,11       ; 1338
.shutter 0101001110110 2,4,7..9,11..12   ; 1339
.shutter 0101001111000 2,4,7..10         ; 1340
.shutter 0101001111010 2,4,7..10,12      ; 1341
.shutter 0101001111100 2,4,7..11         ; 1342
.shutter 0101001111110 2,4,7..12         ; 1343
.shutter 0101010000000 2,4,6             ; 1344
.shutter 0101010000010 2,4,6,12          ; 1345
.shutter 0101010000100 2,4,6,11          ; 1346
.shutter 0101010000110 2,4,6,11..12      ; 1347
.shutter 0101010001000 2,4,6,10          ; 1348
.shutter 0101010001010 2..6/2,10,12      ; 1349
.shutter 0101010001100 2,4,6,10..11      ; 1350
.shutter 0101010001110 2,4,6,10..12      ; 1351
.shutter 0101010010000 2,4,6,9           ; 1352
.shutter 0101010010010 2..6/2,9,12       ; 1353
.shutter 0101010010100 2..6/2,9,11       ; 1354
.shutter 0101010010110 2..6/2,9,11..12   ; 1355
.shutter 0101010011000 2,4,6,9..10       ; 1356
.shutter 0101010011010 2..6/2,9..10,12   ; 1357
.shutter 0101010011100 2,4,6,9..11       ; 1358
.shutter 0101010011110 2,4,6,9..12       ; 1359
.shutter 0101010100000 2,4,6,8           ; 1360
.shutter 0101010100010 2..8/2,12         ; 1361
.shutter 0101010100100 2..8/2,11         ; 1362
.shutter 0101010100110 2..8/2,11..12     ; 1363
.shutter 0101010101000 2..10/2           ; 1364
.shutter 0101010101010 2..12/2           ; 1365
.shutter 0101010101100 2..10/2,11        ; 1366
.shutter 0101010101110 2..10/2,11..12    ; 1367
.shutter 0101010110000 2,4,6,8..9        ; 1368
.shutter 0101010110010 2..8/2,9,12       ; 1369
.shutter 0101010110100 2..8/2,9,11       ; 1370
.shutter 0101010110110 2..8/2,9,11..12   ; 1371
.shutter 0101010111000 2,4,6,8..10       ; 1372
.shutter 0101010111010 2..8/2,9..10,12   ; 1373
.shutter 0101010111100 2,4,6,8..11       ; 1374
.shutter 0101010111110 2,4,6,8..12       ; 1375
.shutter 0101011000000 2,4,6..7          ; 1376
.shutter 0101011000010 2,4,6..7,12       ; 1377
.shutter 0101011000100 2,4,6..7,11       ; 1378
.shutter 0101011000110 2,4,6..7,11..12   ; 1379
.shutter 0101011001000 2,4,6..7,10       ; 1380
.shutter 0101011001010 2..6/2,7,10,12    ; 1381
.shutter 0101011001100 2,4,6..7,10..11   ; 1382
.shutter 0101011001110 2,4,6..7,10..12   ; 1383
.shutter 0101011010000 2,4,6..7,9        ; 1384
.shutter 0101011010010 2..6/2,7,9,12     ; 1385
.shutter 0101011010100 2..6/2,7..11/2    ; 1386
.shutter 0101011010110 2..6/2,7..11/2,12 ; 1387
.shutter 0101011011000 2,4,6..7,9..10    ; 1388
.shutter 0101011011010 2..6/2,7,9..10,12 ; 1389
.shutter 0101011011100 2,4,6..7,9..11    ; 1390
.shutter 0101011011110 2,4,6..7,9..12    ; 1391
.shutter 0101011100000 2,4,6..8          ; 1392
.shutter 0101011100010 2,4,6..8,12       ; 1393
.shutter 0101011100100 2,4,6..8,11       ; 1394
.shutter 0101011100110 2,4,6..8,11..12   ; 1395
.shutter 0101011101000 2,4,6..8,10       ; 1396
.shutter 0101011101010 2..6/2,7..8,10,12 ; 1397
.shutter 0101011101100 2,4,6..8,10..11   ; 1398
.shutter 0101011101110 2,4,6..8,10..12   ; 1399
.shutter 0101011110000 2,4,6..9          ; 1400
.shutter 0101011110010 2,4,6..9,12       ; 1401
.shutter 0101011110100 2,4,6..9,11       ; 1402
.shutter 0101011110110 2,4,6..9,11..12   ; 1403
.shutter 0101011111000 2,4,6..10         ; 1404
.shutter 0101011111010 2,4,6..10,12      ; 1405
.shutter 0101011111100 2,4,6..11         ; 1406
.shutter 0101011111110 2,4,6..12         ; 1407
.shutter 0101100000000 2,4..5            ; 1408
.shutter 0101100000010 2,4..5,12         ; 1409
.shutter 0101100000100 2,4..5,11         ; 1410
.shutter 0101100000110 2,4..5,11..12     ; 1411
.shutter 0101100001000 2,4..5,10         ; 1412
.shutter 0101100001010 2,4..5,10,12      ; 1413
.shutter 0101100001100 2,4..5,10..11     ; 1414
.shutter 0101100001110 2,4..5,10..12     ; 1415
.shutter 0101100010000 2,4..5,9          ; 1416
.shutter 0101100010010 2,4..5,9,12       ; 1417
.shutter 0101100010100 2,4..5,9,11       ; 1418
.shutter 0101100010110 2,4..5,9,11..12   ; 1419
.shutter 0101100011000 2,4..5,9..10      ; 1420
.shutter 0101100011010 2,4..5,9..10,12   ; 1421
.shutter 0101100011100 2,4..5,9..11      ; 1422
.shutter 0101100011110 2,4..5,9..12      ; 1423
.shutter 0101100100000 2,4..5,8          ; 1424
.shutter 0101100100010 2,4..5,8,12       ; 1425
.shutter 0101100100100 2,4..5,8,11       ; 1426
.shutter 0101100100110 2,4..5,8,11..12   ; 1427
.shutter 0101100101000 2,4..5,8,10       ; 1428
.shutter 0101100101010 2,4..5,8..12/2    ; 1429
.shutter 0101100101100 2,4..5,8,10..11   ; 1430
.shutter 0101100101110 2,4..5,8,10..12   ; 1431
.shutter 0101100110000 2,4..5,8..9       ; 1432
.shutter 0101100110010 2,4..5,8..9,12    ; 1433
.shutter 0101100110100 2,4..5,8..9,11    ; 1434
.shutter 0101100110110 2,4..5,8..9,11..12 ; 1435
.shutter 0101100111000 2,4..5,8..10      ; 1436
.shutter 0101100111010 2,4..5,8..10,12   ; 1437
.shutter 0101100111100 2,4..5,8..11      ; 1438
.shutter 0101100111110 2,4..5,8..12      ; 1439
.shutter 0101101000000 2,4..5,7          ; 1440
.shutter 0101101000010 2,4..5,7,12       ; 1441
.shutter 0101101000100 2,4..5,7,11       ; 1442
.shutter 0101101000110 2,4..5,7,11..12   ; 1443
.shutter 0101101001000 2,4..5,7,10       ; 1444
.shutter 0101101001010 2,4..5,7,10,12    ; 1445
.shutter 0101101001100 2,4..5,7,10..11   ; 1446
.shutter 0101101001110 2,4..5,7,10..12   ; 1447
.shutter 0101101010000 2,4..5,7,9        ; 1448
.shutter 0101101010010 2,4..5,7,9,12     ; 1449
.shutter 0101101010100 2,4..5,7..11/2    ; 1450
.shutter 0101101010110 2,4..5,7..11/2,12 ; 1451
.shutter 0101101011000 2,4..5,7,9..10    ; 1452
.shutter 0101101011010 2,4..5,7,9..10,12 ; 1453
.shutter 0101101011100 2,4..5,7,9..11    ; 1454
.shutter 0101101011110 2,4..5,7,9..12    ; 1455
.shutter 0101101100000 2,4..5,7..8       ; 1456
.shutter 0101101100010 2,4..5,7..8,12    ; 1457
.shutter 0101101100100 2,4..5,7..8,11    ; 1458
.shutter 0101101100110 2,4..5,7..8,11..12 ; 1459
.shutter 0101101101000 2,4..5,7..8,10    ; 1460
.shutter 0101101101010 2,4..5,7..8,10,12 ; 1461
.shutter 0101101101100 2,4..5,7..8,10..11 ; 1462
.shutter 0101101101110 2,4..5,7..8,10..12 ; 1463
.shutter 0101101110000 2,4..5,7..9       ; 1464
.shutter 0101101110010 2,4..5,7..9,12    ; 1465
.shutter 0101101110100 2,4..5,7..9,11    ; 1466
.shutter 0101101110110 2,4..5,7..9,11..12 ; 1467
.shutter 0101101111000 2,4..5,7..10      ; 1468
.shutter 0101101111010 2,4..5,7..10,12   ; 1469
.shutter 0101101111100 2,4..5,7..11      ; 1470
.shutter 0101101111110 2,4..5,7..12      ; 1471
.shutter 0101110000000 2,4..6            ; 1472
.shutter 0101110000010 2,4..6,12         ; 1473
.shutter 0101110000100 2,4..6,11         ; 1474
.shutter 0101110000110 2,4..6,11..12     ; 1475
.shutter 0101110001000 2,4..6,10         ; 1476
.shutter 0101110001010 2,4..6,10,12      ; 1477
.shutter 0101110001100 2,4..6,10..11     ; 1478
.shutter 0101110001110 2,4..6,10..12     ; 1479
.shutter 0101110010000 2,4..6,9          ; 1480
.shutter 0101110010010 2,4..6,9,12       ; 1481
.shutter 0101110010100 2,4..6,9,11       ; 1482
.shutter 0101110010110 2,4..6,9,11..12   ; 1483
.shutter 0101110011000 2,4..6,9..10      ; 1484
.shutter 0101110011010 2,4..6,9..10,12   ; 1485
.shutter 0101110011100 2,4..6,9..11      ; 1486
.shutter 0101110011110 2,4..6,9..12      ; 1487
.shutter 0101110100000 2,4..6,8          ; 1488
.shutter 0101110100010 2,4..6,8,12       ; 1489
.shutter 0101110100100 2,4..6,8,11       ; 1490
.shutter 0101110100110 2,4..6,8,11..12   ; 1491
.shutter 0101110101000 2,4..6,8,10       ; 1492
.shutter 0101110101010 2,4..6,8..12/2    ; 1493
.shutter 0101110101100 2,4..6,8,10..11   ; 1494
.shutter 0101110101110 2,4..6,8,10..12   ; 1495
.shutter 0101110110000 2,4..6,8..9       ; 1496
.shutter 0101110110010 2,4..6,8..9,12    ; 1497
.shutter 0101110110100 2,4..6,8..9,11    ; 1498
.shutter 0101110110110 2,4..6,8..9,11..12 ; 1499
.shutter 0101110111000 2,4..6,8..10      ; 1500
.shutter 0101110111010 2,4..6,8..10,12   ; 1501
.shutter 0101110111100 2,4..6,8..11      ; 1502
.shutter 0101110111110 2,4..6,8..12      ; 1503
.shutter 0101111000000 2,4..7            ; 1504
.shutter 0101111000010 2,4..7,12         ; 1505
.shutter 0101111000100 2,4..7,11         ; 1506
.shutter 0101111000110 2,4..7,11..12     ; 1507
.shutter 0101111001000 2,4..7,10         ; 1508
.shutter 0101111001010 2,4..7,10,12      ; 1509
.shutter 0101111001100 2,4..7,10..11     ; 1510
.shutter 0101111001110 2,4..7,10..12     ; 1511
.shutter 0101111010000 2,4..7,9          ; 1512
.shutter 0101111010010 2,4..7,9,12       ; 1513
.shutter 0101111010100 2,4..7,9,11       ; 1514
.shutter 0101111010110 2,4..7,9,11..12   ; 1515
.shutter 0101111011000 2,4..7,9..10      ; 1516
.shutter 0101111011010 2,4..7,9..10,12   ; 1517
.shutter 0101111011100 2,4..7,9..11      ; 1518
.shutter 0101111011110 2,4..7,9..12      ; 1519
.shutter 0101111100000 2,4..8            ; 1520
.shutter 0101111100010 2,4..8,12         ; 1521
.shutter 0101111100100 2,4..8,11         ; 1522
.shutter 0101111100110 2,4..8,11..12     ; 1523
.shutter 0101111101000 2,4..8,10         ; 1524
.shutter 0101111101010 2,4..8,10,12      ; 1525
.shutter 0101111101100 2,4..8,10..11     ; 1526
.shutter 0101111101110 2,4..8,10..12     ; 1527
.shutter 0101111110000 2,4..9            ; 1528
.shutter 0101111110010 2,4..9,12         ; 1529
.shutter 0101111110100 2,4..9,11         ; 1530
.shutter 0101111110110 2,4..9,11..12     ; 1531
.shutter 0101111111000 2,4..10           ; 1532
.shutter 0101111111010 2,4..10,12        ; 1533
.shutter 0101111111100 2,4..11           ; 1534
.shutter 0101111111110 2,4..12           ; 1535
.shutter 0110000000000 2..3              ; 1536
.shutter 0110000000010 2..3,12           ; 1537
.shutter 0110000000100 2..3,11           ; 1538
.shutter 0110000000110 2..3,11..12       ; 1539
.shutter 0110000001000 2..3,10           ; 1540
.shutter 0110000001010 2..3,10,12        ; 1541
.shutter 0110000001100 2..3,10..11       ; 1542
.shutter 0110000001110 2..3,10..12       ; 1543
.shutter 0110000010000 2..3,9            ; 1544
.shutter 0110000010010 2..3,9,12         ; 1545
.shutter 0110000010100 2..3,9,11         ; 1546
.shutter 0110000010110 2..3,9,11..12     ; 1547
.shutter 0110000011000 2..3,9..10        ; 1548
.shutter 0110000011010 2..3,9..10,12     ; 1549
.shutter 0110000011100 2..3,9..11        ; 1550
.shutter 0110000011110 2..3,9..12        ; 1551
.shutter 0110000100000 2..3,8            ; 1552
.shutter 0110000100010 2..3,8,12         ; 1553
.shutter 0110000100100 2..3,8,11         ; 1554
.shutter 0110000100110 2..3,8,11..12     ; 1555
.shutter 0110000101000 2..3,8,10         ; 1556
.shutter 0110000101010 2..3,8,10,12      ; 1557
.shutter 0110000101100 2..3,8,10..11     ; 1558
.shutter 0110000101110 2..3,8,10..12     ; 1559
.shutter 0110000110000 2..3,8..9         ; 1560
.shutter 0110000110010 2..3,8..9,12      ; 1561
.shutter 0110000110100 2..3,8..9,11      ; 1562
.shutter 0110000110110 2..3,8..9,11..12  ; 1563
.shutter 0110000111000 2..3,8..10        ; 1564
.shutter 0110000111010 2..3,8..10,12     ; 1565
.shutter 0110000111100 2..3,8..11        ; 1566
.shutter 0110000111110 2..3,8..12        ; 1567
.shutter 0110001000000 2..3,7            ; 1568
.shutter 0110001000010 2..3,7,12         ; 1569
.shutter 0110001000100 2..3,7,11         ; 1570
.shutter 0110001000110 2..3,7,11..12     ; 1571
.shutter 0110001001000 2..3,7,10         ; 1572
.shutter 0110001001010 2..3,7,10,12      ; 1573
.shutter 0110001001100 2..3,7,10..11     ; 1574
.shutter 0110001001110 2..3,7,10..12     ; 1575
.shutter 0110001010000 2..3,7,9          ; 1576
.shutter 0110001010010 2..3,7,9,12       ; 1577
.shutter 0110001010100 2..3,7,9,11       ; 1578
.shutter 0110001010110 2..3,7,9,11..12   ; 1579
.shutter 0110001011000 2..3,7,9..10      ; 1580
.shutter 0110001011010 2..3,7,9..10,12   ; 1581
.shutter 0110001011100 2..3,7,9..11      ; 1582
.shutter 0110001011110 2..3,7,9..12      ; 1583
.shutter 0110001100000 2..3,7..8         ; 1584
.shutter 0110001100010 2..3,7..8,12      ; 1585
.shutter 0110001100100 2..3,7..8,11      ; 1586
.shutter 0110001100110 2..3,7..8,11..12  ; 1587
.shutter 0110001101000 2..3,7..8,10      ; 1588
.shutter 0110001101010 2..3,7..8,10,12   ; 1589
.shutter 0110001101100 2..3,7..8,10..11  ; 1590
.shutter 0110001101110 2..3,7..8,10..12  ; 1591
.shutter 0110001110000 2..3,7..9         ; 1592
.shutter 0110001110010 2..3,7..9,12      ; 1593
.shutter 0110001110100 2..3,7..9,11      ; 1594
.shutter 0110001110110 2..3,7..9,11..12  ; 1595
.shutter 0110001111000 2..3,7..10        ; 1596
.shutter 0110001111010 2..3,7..10,12     ; 1597
.shutter 0110001111100 2..3,7..11        ; 1598
.shutter 0110001111110 2..3,7..12        ; 1599
.shutter 0110010000000 2..3,6            ; 1600
.shutter 0110010000010 2..3,6,12         ; 1601
.shutter 0110010000100 2..3,6,11         ; 1602
.shutter 0110010000110 2..3,6,11..12     ; 1603
.shutter 0110010001000 2..3,6,10         ; 1604
.shutter 0110010001010 2..3,6,10,12      ; 1605
.shutter 0110010001100 2..3,6,10..11     ; 1606
.shutter 0110010001110 2..3,6,10..12     ; 1607
.shutter 0110010010000 2..3,6,9          ; 1608
.shutter 0110010010010 2..3,6,9,12       ; 1609
.shutter 0110010010100 2..3,6,9,11       ; 1610
.shutter 0110010010110 2..3,6,9,11..12   ; 1611
.shutter 0110010011000 2..3,6,9..10      ; 1612
.shutter 0110010011010 2..3,6,9..10,12   ; 1613
.shutter 0110010011100 2..3,6,9..11      ; 1614
.shutter 0110010011110 2..3,6,9..12      ; 1615
.shutter 0110010100000 2..3,6,8          ; 1616
.shutter 0110010100010 2..3,6,8,12       ; 1617
.shutter 0110010100100 2..3,6,8,11       ; 1618
.shutter 0110010100110 2..3,6,8,11..12   ; 1619
.shutter 0110010101000 2..3,6,8,10       ; 1620
.shutter 0110010101010 2..3,6..12/2      ; 1621
.shutter 0110010101100 2..3,6,8,10..11   ; 1622
.shutter 0110010101110 2..3,6,8,10..12   ; 1623
.shutter 0110010110000 2..3,6,8..9       ; 1624
.shutter 0110010110010 2..3,6,8..9,12    ; 1625
.shutter 0110010110100 2..3,6,8..9,11    ; 1626
.shutter 0110010110110 2..3,6,8..9,11..12 ; 1627
.shutter 0110010111000 2..3,6,8..10      ; 1628
.shutter 0110010111010 2..3,6,8..10,12   ; 1629
.shutter 0110010111100 2..3,6,8..11      ; 1630
.shutter 0110010111110 2..3,6,8..12      ; 1631
.shutter 0110011000000 2..3,6..7         ; 1632
.shutter 0110011000010 2..3,6..7,12      ; 1633
.shutter 0110011000100 2..3,6..7,11      ; 1634
.shutter 0110011000110 2..3,6..7,11..12  ; 1635
.shutter 0110011001000 2..3,6..7,10      ; 1636
.shutter 0110011001010 2..3,6..7,10,12   ; 1637
.shutter 0110011001100 2..3,6..7,10..11  ; 1638
.shutter 0110011001110 2..3,6..7,10..12  ; 1639
.shutter 0110011010000 2..3,6..7,9       ; 1640
.shutter 0110011010010 2..3,6..7,9,12    ; 1641
.shutter 0110011010100 2..3,6..7,9,11    ; 1642
.shutter 0110011010110 2..3,6..7,9,11..12 ; 1643
.shutter 0110011011000 2..3,6..7,9..10   ; 1644
.shutter 0110011011010 2..3,6..7,9..10,12 ; 1645
.shutter 0110011011100 2..3,6..7,9..11   ; 1646
.shutter 0110011011110 2..3,6..7,9..12   ; 1647
.shutter 0110011100000 2..3,6..8         ; 1648
.shutter 0110011100010 2..3,6..8,12      ; 1649
.shutter 0110011100100 2..3,6..8,11      ; 1650
.shutter 0110011100110 2..3,6..8,11..12  ; 1651
.shutter 0110011101000 2..3,6..8,10      ; 1652
.shutter 0110011101010 2..3,6..8,10,12   ; 1653
.shutter 0110011101100 2..3,6..8,10..11  ; 1654
.shutter 0110011101110 2..3,6..8,10..12  ; 1655
.shutter 0110011110000 2..3,6..9         ; 1656
.shutter 0110011110010 2..3,6..9,12      ; 1657
.shutter 0110011110100 2..3,6..9,11      ; 1658
.shutter 0110011110110 2..3,6..9,11..12  ; 1659
.shutter 0110011111000 2..3,6..10        ; 1660
.shutter 0110011111010 2..3,6..10,12     ; 1661
.shutter 0110011111100 2..3,6..11        ; 1662
.shutter 0110011111110 2..3,6..12        ; 1663
.shutter 0110100000000 2..3,5            ; 1664
.shutter 0110100000010 2..3,5,12         ; 1665
.shutter 0110100000100 2..3,5,11         ; 1666
.shutter 0110100000110 2..3,5,11..12     ; 1667
.shutter 0110100001000 2..3,5,10         ; 1668
.shutter 0110100001010 2..3,5,10,12      ; 1669
.shutter 0110100001100 2..3,5,10..11     ; 1670
.shutter 0110100001110 2..3,5,10..12     ; 1671
.shutter 0110100010000 2..3,5,9          ; 1672
.shutter 0110100010010 2..3,5,9,12       ; 1673
.shutter 0110100010100 2..3,5,9,11       ; 1674
.shutter 0110100010110 2..3,5,9,11..12   ; 1675
.shutter 0110100011000 2..3,5,9..10      ; 1676
.shutter 0110100011010 2..3,5,9..10,12   ; 1677
.shutter 0110100011100 2..3,5,9..11      ; 1678
.shutter 0110100011110 2..3,5,9..12      ; 1679
.shutter 0110100100000 2..3,5,8          ; 1680
.shutter 0110100100010 2..3,5,8,12       ; 1681
.shutter 0110100100100 2..3,5,8,11       ; 1682
.shutter 0110100100110 2..3,5,8,11..12   ; 1683
.shutter 0110100101000 2..3,5,8,10       ; 1684
.shutter 0110100101010 2..3,5,8..12/2    ; 1685
.shutter 0110100101100 2..3,5,8,10..11   ; 1686
.shutter 0110100101110 2..3,5,8,10..12   ; 1687
.shutter 0110100110000 2..3,5,8..9       ; 1688
.shutter 0110100110010 2..3,5,8..9,12    ; 1689
.shutter 0110100110100 2..3,5,8..9,11    ; 1690
.shutter 0110100110110 2..3,5,8..9,11..12 ; 1691
.shutter 0110100111000 2..3,5,8..10      ; 1692
.shutter 0110100111010 2..3,5,8..10,12   ; 1693
.shutter 0110100111100 2..3,5,8..11      ; 1694
.shutter 0110100111110 2..3,5,8..12      ; 1695
.shutter 0110101000000 2..3,5,7          ; 1696
.shutter 0110101000010 2..3,5,7,12       ; 1697
.shutter 0110101000100 2..3,5,7,11       ; 1698
.shutter 0110101000110 2..3,5,7,11..12   ; 1699
.shutter 0110101001000 2..3,5,7,10       ; 1700
.shutter 0110101001010 2..3,5,7,10,12    ; 1701
.shutter 0110101001100 2..3,5,7,10..11   ; 1702
.shutter 0110101001110 2..3,5,7,10..12   ; 1703
.shutter 0110101010000 2..3,5,7,9        ; 1704
.shutter 0110101010010 2..3,5..9/2,12    ; 1705
.shutter 0110101010100 2..3,5..11/2      ; 1706
.shutter 0110101010110 2..3,5..11/2,12   ; 1707
.shutter 0110101011000 2..3,5,7,9..10    ; 1708
.shutter 0110101011010 2..3,5..9/2,10,12 ; 1709
.shutter 0110101011100 2..3,5,7,9..11    ; 1710
.shutter 0110101011110 2..3,5,7,9..12    ; 1711
.shutter 0110101100000 2..3,5,7..8       ; 1712
.shutter 0110101100010 2..3,5,7..8,12    ; 1713
.shutter 0110101100100 2..3,5,7..8,11    ; 1714
.shutter 0110101100110 2..3,5,7..8,11..12 ; 1715
.shutter 0110101101000 2..3,5,7..8,10    ; 1716
.shutter 0110101101010 2..3,5,7..8,10,12 ; 1717
.shutter 0110101101100 2..3,5,7..8,10..11 ; 1718
.shutter 0110101101110 2..3,5,7..8,10..12 ; 1719
.shutter 0110101110000 2..3,5,7..9       ; 1720
.shutter 0110101110010 2..3,5,7..9,12    ; 1721
.shutter 0110101110100 2..3,5,7..9,11    ; 1722
.shutter 0110101110110 2..3,5,7..9,11..12 ; 1723
.shutter 0110101111000 2..3,5,7..10      ; 1724
.shutter 0110101111010 2..3,5,7..10,12   ; 1725
.shutter 0110101111100 2..3,5,7..11      ; 1726
.shutter 0110101111110 2..3,5,7..12      ; 1727
.shutter 0110110000000 2..3,5..6         ; 1728
.shutter 0110110000010 2..3,5..6,12      ; 1729
.shutter 0110110000100 2..3,5..6,11      ; 1730
.shutter 0110110000110 2..3,5..6,11..12  ; 1731
.shutter 0110110001000 2..3,5..6,10      ; 1732
.shutter 0110110001010 2..3,5..6,10,12   ; 1733
.shutter 0110110001100 2..3,5..6,10..11  ; 1734
.shutter 0110110001110 2..3,5..6,10..12  ; 1735
.shutter 0110110010000 2..3,5..6,9       ; 1736
.shutter 0110110010010 2..3,5..6,9,12    ; 1737
.shutter 0110110010100 2..3,5..6,9,11    ; 1738
.shutter 0110110010110 2..3,5..6,9,11..12 ; 1739
.shutter 0110110011000 2..3,5..6,9..10   ; 1740
.shutter 0110110011010 2..3,5..6,9..10,12 ; 1741
.shutter 0110110011100 2..3,5..6,9..11   ; 1742
.shutter 0110110011110 2..3,5..6,9..12   ; 1743
.shutter 0110110100000 2..3,5..6,8       ; 1744
.shutter 0110110100010 2..3,5..6,8,12    ; 1745
.shutter 0110110100100 2..3,5..6,8,11    ; 1746
.shutter 0110110100110 2..3,5..6,8,11..12 ; 1747
.shutter 0110110101000 2..3,5..6,8,10    ; 1748
.shutter 0110110101010 2..3,5..6,8..12/2 ; 1749
.shutter 0110110101100 2..3,5..6,8,10..11 ; 1750
.shutter 0110110101110 2..3,5..6,8,10..12 ; 1751
.shutter 0110110110000 2..3,5..6,8..9    ; 1752
.shutter 0110110110010 2..3,5..6,8..9,12 ; 1753
.shutter 0110110110100 2..3,5..6,8..9,11 ; 1754
.shutter 0110110110110 2..3,5..6,8..9,11..12 ; 1755
.shutter 0110110111000 2..3,5..6,8..10   ; 1756
.shutter 0110110111010 2..3,5..6,8..10,12 ; 1757
.shutter 0110110111100 2..3,5..6,8..11   ; 1758
.shutter 0110110111110 2..3,5..6,8..12   ; 1759
.shutter 0110111000000 2..3,5..7         ; 1760
.shutter 0110111000010 2..3,5..7,12      ; 1761
.shutter 0110111000100 2..3,5..7,11      ; 1762
.shutter 0110111000110 2..3,5..7,11..12  ; 1763
.shutter 0110111001000 2..3,5..7,10      ; 1764
.shutter 0110111001010 2..3,5..7,10,12   ; 1765
.shutter 0110111001100 2..3,5..7,10..11  ; 1766
.shutter 0110111001110 2..3,5..7,10..12  ; 1767
.shutter 0110111010000 2..3,5..7,9       ; 1768
.shutter 0110111010010 2..3,5..7,9,12    ; 1769
.shutter 0110111010100 2..3,5..7,9,11    ; 1770
.shutter 0110111010110 2..3,5..7,9,11..12 ; 1771
.shutter 0110111011000 2..3,5..7,9..10   ; 1772
.shutter 0110111011010 2..3,5..7,9..10,12 ; 1773
.shutter 0110111011100 2..3,5..7,9..11   ; 1774
.shutter 0110111011110 2..3,5..7,9..12   ; 1775
.shutter 0110111100000 2..3,5..8         ; 1776
.shutter 0110111100010 2..3,5..8,12      ; 1777
.shutter 0110111100100 2..3,5..8,11      ; 1778
.shutter 0110111100110 2..3,5..8,11..12  ; 1779
.shutter 0110111101000 2..3,5..8,10      ; 1780
.shutter 0110111101010 2..3,5..8,10,12   ; 1781
.shutter 0110111101100 2..3,5..8,10..11  ; 1782
.shutter 0110111101110 2..3,5..8,10..12  ; 1783
.shutter 0110111110000 2..3,5..9         ; 1784
.shutter 0110111110010 2..3,5..9,12      ; 1785
.shutter 0110111110100 2..3,5..9,11      ; 1786
.shutter 0110111110110 2..3,5..9,11..12  ; 1787
.shutter 0110111111000 2..3,5..10        ; 1788
.shutter 0110111111010 2..3,5..10,12     ; 1789
.shutter 0110111111100 2..3,5..11        ; 1790
.shutter 0110111111110 2..3,5..12        ; 1791
.shutter 0111000000000 2..4              ; 1792
.shutter 0111000000010 2..4,12           ; 1793
.shutter 0111000000100 2..4,11           ; 1794
.shutter 0111000000110 2..4,11..12       ; 1795
.shutter 0111000001000 2..4,10           ; 1796
.shutter 0111000001010 2..4,10,12        ; 1797
.shutter 0111000001100 2..4,10..11       ; 1798
.shutter 0111000001110 2..4,10..12       ; 1799
.shutter 0111000010000 2..4,9            ; 1800
.shutter 0111000010010 2..4,9,12         ; 1801
.shutter 0111000010100 2..4,9,11         ; 1802
.shutter 0111000010110 2..4,9,11..12     ; 1803
.shutter 0111000011000 2..4,9..10        ; 1804
.shutter 0111000011010 2..4,9..10,12     ; 1805
.shutter 0111000011100 2..4,9..11        ; 1806
.shutter 0111000011110 2..4,9..12        ; 1807
.shutter 0111000100000 2..4,8            ; 1808
.shutter 0111000100010 2..4,8,12         ; 1809
.shutter 0111000100100 2..4,8,11         ; 1810
.shutter 0111000100110 2..4,8,11..12     ; 1811
.shutter 0111000101000 2..4,8,10         ; 1812
.shutter 0111000101010 2..4,8,10,12      ; 1813
.shutter 0111000101100 2..4,8,10..11     ; 1814
.shutter 0111000101110 2..4,8,10..12     ; 1815
.shutter 0111000110000 2..4,8..9         ; 1816
.shutter 0111000110010 2..4,8..9,12      ; 1817
.shutter 0111000110100 2..4,8..9,11      ; 1818
.shutter 0111000110110 2..4,8..9,11..12  ; 1819
.shutter 0111000111000 2..4,8..10        ; 1820
.shutter 0111000111010 2..4,8..10,12     ; 1821
.shutter 0111000111100 2..4,8..11        ; 1822
.shutter 0111000111110 2..4,8..12        ; 1823
.shutter 0111001000000 2..4,7            ; 1824
.shutter 0111001000010 2..4,7,12         ; 1825
.shutter 0111001000100 2..4,7,11         ; 1826
.shutter 0111001000110 2..4,7,11..12     ; 1827
.shutter 0111001001000 2..4,7,10         ; 1828
.shutter 0111001001010 2..4,7,10,12      ; 1829
.shutter 0111001001100 2..4,7,10..11     ; 1830
.shutter 0111001001110 2..4,7,10..12     ; 1831
.shutter 0111001010000 2..4,7,9          ; 1832
.shutter 0111001010010 2..4,7,9,12       ; 1833
.shutter 0111001010100 2..4,7,9,11       ; 1834
.shutter 0111001010110 2..4,7,9,11..12   ; 1835
.shutter 0111001011000 2..4,7,9..10      ; 1836
.shutter 0111001011010 2..4,7,9..10,12   ; 1837
.shutter 0111001011100 2..4,7,9..11      ; 1838
.shutter 0111001011110 2..4,7,9..12      ; 1839
.shutter 0111001100000 2..4,7..8         ; 1840
.shutter 0111001100010 2..4,7..8,12      ; 1841
.shutter 0111001100100 2..4,7..8,11      ; 1842
.shutter 0111001100110 2..4,7..8,11..12  ; 1843
.shutter 0111001101000 2..4,7..8,10      ; 1844
.shutter 0111001101010 2..4,7..8,10,12   ; 1845
.shutter 0111001101100 2..4,7..8,10..11  ; 1846
.shutter 0111001101110 2..4,7..8,10..12  ; 1847
.shutter 0111001110000 2..4,7..9         ; 1848
.shutter 0111001110010 2..4,7..9,12      ; 1849
.shutter 0111001110100 2..4,7..9,11      ; 1850
.shutter 0111001110110 2..4,7..9,11..12  ; 1851
.shutter 0111001111000 2..4,7..10        ; 1852
.shutter 0111001111010 2..4,7..10,12     ; 1853
.shutter 0111001111100 2..4,7..11        ; 1854
.shutter 0111001111110 2..4,7..12        ; 1855
.shutter 0111010000000 2..4,6            ; 1856
.shutter 0111010000010 2..4,6,12         ; 1857
.shutter 0111010000100 2..4,6,11         ; 1858
.shutter 0111010000110 2..4,6,11..12     ; 1859
.shutter 0111010001000 2..4,6,10         ; 1860
.shutter 0111010001010 2..4,6,10,12      ; 1861
.shutter 0111010001100 2..4,6,10..11     ; 1862
.shutter 0111010001110 2..4,6,10..12     ; 1863
.shutter 0111010010000 2..4,6,9          ; 1864
.shutter 0111010010010 2..4,6,9,12       ; 1865
.shutter 0111010010100 2..4,6,9,11       ; 1866
.shutter 0111010010110 2..4,6,9,11..12   ; 1867
.shutter 0111010011000 2..4,6,9..10      ; 1868
.shutter 0111010011010 2..4,6,9..10,12   ; 1869
.shutter 0111010011100 2..4,6,9..11      ; 1870
.shutter 0111010011110 2..4,6,9..12      ; 1871
.shutter 0111010100000 2..4,6,8          ; 1872
.shutter 0111010100010 2..4,6,8,12       ; 1873
.shutter 0111010100100 2..4,6,8,11       ; 1874
.shutter 0111010100110 2..4,6,8,11..12   ; 1875
.shutter 0111010101000 2..4,6,8,10       ; 1876
.shutter 0111010101010 2..4,6..12/2      ; 1877
.shutter 0111010101100 2..4,6,8,10..11   ; 1878
.shutter 0111010101110 2..4,6,8,10..12   ; 1879
.shutter 0111010110000 2..4,6,8..9       ; 1880
.shutter 0111010110010 2..4,6,8..9,12    ; 1881
.shutter 0111010110100 2..4,6,8..9,11    ; 1882
.shutter 0111010110110 2..4,6,8..9,11..12 ; 1883
.shutter 0111010111000 2..4,6,8..10      ; 1884
.shutter 0111010111010 2..4,6,8..10,12   ; 1885
.shutter 0111010111100 2..4,6,8..11      ; 1886
.shutter 0111010111110 2..4,6,8..12      ; 1887
.shutter 0111011000000 2..4,6..7         ; 1888
.shutter 0111011000010 2..4,6..7,12      ; 1889
.shutter 0111011000100 2..4,6..7,11      ; 1890
.shutter 0111011000110 2..4,6..7,11..12  ; 1891
.shutter 0111011001000 2..4,6..7,10      ; 1892
.shutter 0111011001010 2..4,6..7,10,12   ; 1893
.shutter 0111011001100 2..4,6..7,10..11  ; 1894
.shutter 0111011001110 2..4,6..7,10..12  ; 1895
.shutter 0111011010000 2..4,6..7,9       ; 1896
.shutter 0111011010010 2..4,6..7,9,12    ; 1897
.shutter 0111011010100 2..4,6..7,9,11    ; 1898
.shutter 0111011010110 2..4,6..7,9,11..12 ; 1899
.shutter 0111011011000 2..4,6..7,9..10   ; 1900
.shutter 0111011011010 2..4,6..7,9..10,12 ; 1901
.shutter 0111011011100 2..4,6..7,9..11   ; 1902
.shutter 0111011011110 2..4,6..7,9..12   ; 1903
.shutter 0111011100000 2..4,6..8         ; 1904
.shutter 0111011100010 2..4,6..8,12      ; 1905
.shutter 0111011100100 2..4,6..8,11      ; 1906
.shutter 0111011100110 2..4,6..8,11..12  ; 1907
.shutter 0111011101000 2..4,6..8,10      ; 1908
.shutter 0111011101010 2..4,6..8,10,12   ; 1909
.shutter 0111011101100 2..4,6..8,10..11  ; 1910
.shutter 0111011101110 2..4,6..8,10..12  ; 1911
.shutter 0111011110000 2..4,6..9         ; 1912
.shutter 0111011110010 2..4,6..9,12      ; 1913
.shutter 0111011110100 2..4,6..9,11      ; 1914
.shutter 0111011110110 2..4,6..9,11..12  ; 1915
.shutter 0111011111000 2..4,6..10        ; 1916
.shutter 0111011111010 2..4,6..10,12     ; 1917
.shutter 0111011111100 2..4,6..11        ; 1918
.shutter 0111011111110 2..4,6..12        ; 1919
.shutter 0111100000000 2..5              ; 1920
.shutter 0111100000010 2..5,12           ; 1921
.shutter 0111100000100 2..5,11           ; 1922
.shutter 0111100000110 2..5,11..12       ; 1923
.shutter 0111100001000 2..5,10           ; 1924
.shutter 0111100001010 2..5,10,12        ; 1925
.shutter 0111100001100 2..5,10..11       ; 1926
.shutter 0111100001110 2..5,10..12       ; 1927
.shutter 0111100010000 2..5,9            ; 1928
.shutter 0111100010010 2..5,9,12         ; 1929
.shutter 0111100010100 2..5,9,11         ; 1930
.shutter 0111100010110 2..5,9,11..12     ; 1931
.shutter 0111100011000 2..5,9..10        ; 1932
.shutter 0111100011010 2..5,9..10,12     ; 1933
.shutter 0111100011100 2..5,9..11        ; 1934
.shutter 0111100011110 2..5,9..12        ; 1935
.shutter 0111100100000 2..5,8            ; 1936
.shutter 0111100100010 2..5,8,12         ; 1937
.shutter 0111100100100 2..5,8,11         ; 1938
.shutter 0111100100110 2..5,8,11..12     ; 1939
.shutter 0111100101000 2..5,8,10         ; 1940
.shutter 0111100101010 2..5,8,10,12      ; 1941
.shutter 0111100101100 2..5,8,10..11     ; 1942
.shutter 0111100101110 2..5,8,10..12     ; 1943
.shutter 0111100110000 2..5,8..9         ; 1944
.shutter 0111100110010 2..5,8..9,12      ; 1945
.shutter 0111100110100 2..5,8..9,11      ; 1946
.shutter 0111100110110 2..5,8..9,11..12  ; 1947
.shutter 0111100111000 2..5,8..10        ; 1948
.shutter 0111100111010 2..5,8..10,12     ; 1949
.shutter 0111100111100 2..5,8..11        ; 1950
.shutter 0111100111110 2..5,8..12        ; 1951
.shutter 0111101000000 2..5,7            ; 1952
.shutter 0111101000010 2..5,7,12         ; 1953
.shutter 0111101000100 2..5,7,11         ; 1954
.shutter 0111101000110 2..5,7,11..12     ; 1955
.shutter 0111101001000 2..5,7,10         ; 1956
.shutter 0111101001010 2..5,7,10,12      ; 1957
.shutter 0111101001100 2..5,7,10..11     ; 1958
.shutter 0111101001110 2..5,7,10..12     ; 1959
.shutter 0111101010000 2..5,7,9          ; 1960
.shutter 0111101010010 2..5,7,9,12       ; 1961
.shutter 0111101010100 2..5,7,9,11       ; 1962
.shutter 0111101010110 2..5,7,9,11..12   ; 1963
.shutter 0111101011000 2..5,7,9..10      ; 1964
.shutter 0111101011010 2..5,7,9..10,12   ; 1965
.shutter 0111101011100 2..5,7,9..11      ; 1966
.shutter 0111101011110 2..5,7,9..12      ; 1967
.shutter 0111101100000 2..5,7..8         ; 1968
.shutter 0111101100010 2..5,7..8,12      ; 1969
.shutter 0111101100100 2..5,7..8,11      ; 1970
.shutter 0111101100110 2..5,7..8,11..12  ; 1971
.shutter 0111101101000 2..5,7..8,10      ; 1972
.shutter 0111101101010 2..5,7..8,10,12   ; 1973
.shutter 0111101101100 2..5,7..8,10..11  ; 1974
.shutter 0111101101110 2..5,7..8,10..12  ; 1975
.shutter 0111101110000 2..5,7..9         ; 1976
.shutter 0111101110010 2..5,7..9,12      ; 1977
.shutter 0111101110100 2..5,7..9,11      ; 1978
.shutter 0111101110110 2..5,7..9,11..12  ; 1979
.shutter 0111101111000 2..5,7..10        ; 1980
.shutter 0111101111010 2..5,7..10,12     ; 1981
.shutter 0111101111100 2..5,7..11        ; 1982
.shutter 0111101111110 2..5,7..12        ; 1983
.shutter 0111110000000 2..6              ; 1984
.shutter 0111110000010 2..6,12           ; 1985
.shutter 0111110000100 2..6,11           ; 1986
.shutter 0111110000110 2..6,11..12       ; 1987
.shutter 0111110001000 2..6,10           ; 1988
.shutter 0111110001010 2..6,10,12        ; 1989
.shutter 0111110001100 2..6,10..11       ; 1990
.shutter 0111110001110 2..6,10..12       ; 1991
.shutter 0111110010000 2..6,9            ; 1992
.shutter 0111110010010 2..6,9,12         ; 1993
.shutter 0111110010100 2..6,9,11         ; 1994
.shutter 0111110010110 2..6,9,11..12     ; 1995
.shutter 0111110011000 2..6,9..10        ; 1996
.shutter 0111110011010 2..6,9..10,12     ; 1997
.shutter 0111110011100 2..6,9..11        ; 1998
.shutter 0111110011110 2..6,9..12        ; 1999
.shutter 0111110100000 2..6,8            ; 2000
.shutter 0111110100010 2..6,8,12         ; 2001
.shutter 0111110100100 2..6,8,11         ; 2002
.shutter 0111110100110 2..6,8,11..12     ; 2003
.shutter 0111110101000 2..6,8,10         ; 2004
.shutter 0111110101010 2..6,8,10,12      ; 2005
.shutter 0111110101100 2..6,8,10..11     ; 2006
.shutter 0111110101110 2..6,8,10..12     ; 2007
.shutter 0111110110000 2..6,8..9         ; 2008
.shutter 0111110110010 2..6,8..9,12      ; 2009
.shutter 0111110110100 2..6,8..9,11      ; 2010
.shutter 0111110110110 2..6,8..9,11..12  ; 2011
.shutter 0111110111000 2..6,8..10        ; 2012
.shutter 0111110111010 2..6,8..10,12     ; 2013
.shutter 0111110111100 2..6,8..11        ; 2014
.shutter 0111110111110 2..6,8..12        ; 2015
.shutter 0111111000000 2..7              ; 2016
.shutter 0111111000010 2..7,12           ; 2017
.shutter 0111111000100 2..7,11           ; 2018
.shutter 0111111000110 2..7,11..12       ; 2019
.shutter 0111111001000 2..7,10           ; 2020
.shutter 0111111001010 2..7,10,12        ; 2021
.shutter 0111111001100 2..7,10..11       ; 2022
.shutter 0111111001110 2..7,10..12       ; 2023
.shutter 0111111010000 2..7,9            ; 2024
.shutter 0111111010010 2..7,9,12         ; 2025
.shutter 0111111010100 2..7,9,11         ; 2026
.shutter 0111111010110 2..7,9,11..12     ; 2027
.shutter 0111111011000 2..7,9..10        ; 2028
.shutter 0111111011010 2..7,9..10,12     ; 2029
.shutter 0111111011100 2..7,9..11        ; 2030
.shutter 0111111011110 2..7,9..12        ; 2031
.shutter 0111111100000 2..8              ; 2032
.shutter 0111111100010 2..8,12           ; 2033
.shutter 0111111100100 2..8,11           ; 2034
.shutter 0111111100110 2..8,11..12       ; 2035
.shutter 0111111101000 2..8,10           ; 2036
.shutter 0111111101010 2..8,10,12        ; 2037
.shutter 0111111101100 2..8,10..11       ; 2038
.shutter 0111111101110 2..8,10..12       ; 2039
.shutter 0111111110000 2..9              ; 2040
.shutter 0111111110010 2..9,12           ; 2041
.shutter 0111111110100 2..9,11           ; 2042
.shutter 0111111110110 2..9,11..12       ; 2043
.shutter 0111111111000 2..10             ; 2044
.shutter 0111111111010 2..10,12          ; 2045
.shutter 0111111111100 2..11             ; 2046
.shutter 0111111111110 2..12             ; 2047
.shutter 1000000000000 1                 ; 2048
.shutter 1000000000010 1,12              ; 2049
.shutter 1000000000100 1,11              ; 2050
.shutter 1000000000110 1,11..12          ; 2051
.shutter 1000000001000 1,10              ; 2052
.shutter 1000000001010 1,10,12           ; 2053
.shutter 1000000001100 1,10..11          ; 2054
.shutter 1000000001110 1,10..12          ; 2055
.shutter 1000000010000 1,9               ; 2056
.shutter 1000000010010 1,9,12            ; 2057
.shutter 1000000010100 1,9,11            ; 2058
.shutter 1000000010110 1,9,11..12        ; 2059
.shutter 1000000011000 1,9..10           ; 2060
.shutter 1000000011010 1,9..10,12        ; 2061
.shutter 1000000011100 1,9..11           ; 2062
.shutter 1000000011110 1,9..12           ; 2063
.shutter 1000000100000 1,8               ; 2064
.shutter 1000000100010 1,8,12            ; 2065
.shutter 1000000100100 1,8,11            ; 2066
.shutter 1000000100110 1,8,11..12        ; 2067
.shutter 1000000101000 1,8,10            ; 2068
.shutter 1000000101010 1,8,10,12         ; 2069
.shutter 1000000101100 1,8,10..11        ; 2070
.shutter 1000000101110 1,8,10..12        ; 2071
.shutter 1000000110000 1,8..9            ; 2072
.shutter 1000000110010 1,8..9,12         ; 2073
.shutter 1000000110100 1,8..9,11         ; 2074
.shutter 1000000110110 1,8..9,11..12     ; 2075
.shutter 1000000111000 1,8..10           ; 2076
.shutter 1000000111010 1,8..10,12        ; 2077
.shutter 1000000111100 1,8..11           ; 2078
.shutter 1000000111110 1,8..12           ; 2079
.shutter 1000001000000 1,7               ; 2080
.shutter 1000001000010 1,7,12            ; 2081
.shutter 1000001000100 1,7,11            ; 2082
.shutter 1000001000110 1,7,11..12        ; 2083
.shutter 1000001001000 1,7,10            ; 2084
.shutter 1000001001010 1,7,10,12         ; 2085
.shutter 1000001001100 1,7,10..11        ; 2086
.shutter 1000001001110 1,7,10..12        ; 2087
.shutter 1000001010000 1,7,9             ; 2088
.shutter 1000001010010 1,7,9,12          ; 2089
.shutter 1000001010100 1,7,9,11          ; 2090
.shutter 1000001010110 1,7,9,11..12      ; 2091
.shutter 1000001011000 1,7,9..10         ; 2092
.shutter 1000001011010 1,7,9..10,12      ; 2093
.shutter 1000001011100 1,7,9..11         ; 2094
.shutter 1000001011110 1,7,9..12         ; 2095
.shutter 1000001100000 1,7..8            ; 2096
.shutter 1000001100010 1,7..8,12         ; 2097
.shutter 1000001100100 1,7..8,11         ; 2098
.shutter 1000001100110 1,7..8,11..12     ; 2099
.shutter 1000001101000 1,7..8,10         ; 2100
.shutter 1000001101010 1,7..8,10,12      ; 2101
.shutter 1000001101100 1,7..8,10..11     ; 2102
.shutter 1000001101110 1,7..8,10..12     ; 2103
.shutter 1000001110000 1,7..9            ; 2104
.shutter 1000001110010 1,7..9,12         ; 2105
.shutter 1000001110100 1,7..9,11         ; 2106
.shutter 1000001110110 1,7..9,11..12     ; 2107
.shutter 1000001111000 1,7..10           ; 2108
.shutter 1000001111010 1,7..10,12        ; 2109
.shutter 1000001111100 1,7..11           ; 2110
.shutter 1000001111110 1,7..12           ; 2111
.shutter 1000010000000 1,6               ; 2112
.shutter 1000010000010 1,6,12            ; 2113
.shutter 1000010000100 1,6,11            ; 2114
.shutter 1000010000110 1,6,11..12        ; 2115
.shutter 1000010001000 1,6,10            ; 2116
.shutter 1000010001010 1,6,10,12         ; 2117
.shutter 1000010001100 1,6,10..11        ; 2118
.shutter 1000010001110 1,6,10..12        ; 2119
.shutter 1000010010000 1,6,9             ; 2120
.shutter 1000010010010 1,6,9,12          ; 2121
.shutter 1000010010100 1,6,9,11          ; 2122
.shutter 1000010010110 1,6,9,11..12      ; 2123
.shutter 1000010011000 1,6,9..10         ; 2124
.shutter 1000010011010 1,6,9..10,12      ; 2125
.shutter 1000010011100 1,6,9..11         ; 2126
.shutter 1000010011110 1,6,9..12         ; 2127
.shutter 1000010100000 1,6,8             ; 2128
.shutter 1000010100010 1,6,8,12          ; 2129
.shutter 1000010100100 1,6,8,11          ; 2130
.shutter 1000010100110 1,6,8,11..12      ; 2131
.shutter 1000010101000 1,6,8,10          ; 2132
.shutter 1000010101010 1,6..12/2         ; 2133
.shutter 1000010101100 1,6,8,10..11      ; 2134
.shutter 1000010101110 1,6,8,10..12      ; 2135
.shutter 1000010110000 1,6,8..9          ; 2136
.shutter 1000010110010 1,6,8..9,12       ; 2137
.shutter 1000010110100 1,6,8..9,11       ; 2138
.shutter 1000010110110 1,6,8..9,11..12   ; 2139
.shutter 1000010111000 1,6,8..10         ; 2140
.shutter 1000010111010 1,6,8..10,12      ; 2141
.shutter 1000010111100 1,6,8..11         ; 2142
.shutter 1000010111110 1,6,8..12         ; 2143
.shutter 1000011000000 1,6..7            ; 2144
.shutter 1000011000010 1,6..7,12         ; 2145
.shutter 1000011000100 1,6..7,11         ; 2146
.shutter 1000011000110 1,6..7,11..12     ; 2147
.shutter 1000011001000 1,6..7,10         ; 2148
.shutter 1000011001010 1,6..7,10,12      ; 2149
.shutter 1000011001100 1,6..7,10..11     ; 2150
.shutter 1000011001110 1,6..7,10..12     ; 2151
.shutter 1000011010000 1,6..7,9          ; 2152
.shutter 1000011010010 1,6..7,9,12       ; 2153
.shutter 1000011010100 1,6..7,9,11       ; 2154
.shutter 1000011010110 1,6..7,9,11..12   ; 2155
.shutter 1000011011000 1,6..7,9..10      ; 2156
.shutter 1000011011010 1,6..7,9..10,12   ; 2157
.shutter 1000011011100 1,6..7,9..11      ; 2158
.shutter 1000011011110 1,6..7,9..12      ; 2159
.shutter 1000011100000 1,6..8            ; 2160
.shutter 1000011100010 1,6..8,12         ; 2161
.shutter 1000011100100 1,6..8,11         ; 2162
.shutter 1000011100110 1,6..8,11..12     ; 2163
.shutter 1000011101000 1,6..8,10         ; 2164
.shutter 1000011101010 1,6..8,10,12      ; 2165
.shutter 1000011101100 1,6..8,10..11     ; 2166
.shutter 1000011101110 1,6..8,10..12     ; 2167
.shutter 1000011110000 1,6..9            ; 2168
.shutter 1000011110010 1,6..9,12         ; 2169
.shutter 1000011110100 1,6..9,11         ; 2170
.shutter 1000011110110 1,6..9,11..12     ; 2171
.shutter 1000011111000 1,6..10           ; 2172
.shutter 1000011111010 1,6..10,12        ; 2173
.shutter 1000011111100 1,6..11           ; 2174
.shutter 1000011111110 1,6..12           ; 2175
.shutter 1000100000000 1,5               ; 2176
.shutter 1000100000010 1,5,12            ; 2177
.shutter 1000100000100 1,5,11            ; 2178
.shutter 1000100000110 1,5,11..12        ; 2179
.shutter 1000100001000 1,5,10            ; 2180
.shutter 1000100001010 1,5,10,12         ; 2181
.shutter 1000100001100 1,5,10..11        ; 2182
.shutter 1000100001110 1,5,10..12        ; 2183
.shutter 1000100010000 1,5,9             ; 2184
.shutter 1000100010010 1,5,9,12          ; 2185
.shutter 1000100010100 1,5,9,11          ; 2186
.shutter 1000100010110 1,5,9,11..12      ; 2187
.shutter 1000100011000 1,5,9..10         ; 2188
.shutter 1000100011010 1,5,9..10,12      ; 2189
.shutter 1000100011100 1,5,9..11         ; 2190
.shutter 1000100011110 1,5,9..12         ; 2191
.shutter 1000100100000 1,5,8             ; 2192
.shutter 1000100100010 1,5,8,12          ; 2193
.shutter 1000100100100 1,5,8,11          ; 2194
.shutter 1000100100110 1,5,8,11..12      ; 2195
.shutter 1000100101000 1,5,8,10          ; 2196
.shutter 1000100101010 1,5,8..12/2       ; 2197
.shutter 1000100101100 1,5,8,10..11      ; 2198
.shutter 1000100101110 1,5,8,10..12      ; 2199
.shutter 1000100110000 1,5,8..9          ; 2200
.shutter 1000100110010 1,5,8..9,12       ; 2201
.shutter 1000100110100 1,5,8..9,11       ; 2202
.shutter 1000100110110 1,5,8..9,11..12   ; 2203
.shutter 1000100111000 1,5,8..10         ; 2204
.shutter 1000100111010 1,5,8..10,12      ; 2205
.shutter 1000100111100 1,5,8..11         ; 2206
.shutter 1000100111110 1,5,8..12         ; 2207
.shutter 1000101000000 1,5,7             ; 2208
.shutter 1000101000010 1,5,7,12          ; 2209
.shutter 1000101000100 1,5,7,11          ; 2210
.shutter 1000101000110 1,5,7,11..12      ; 2211
.shutter 1000101001000 1,5,7,10          ; 2212
.shutter 1000101001010 1,5,7,10,12       ; 2213
.shutter 1000101001100 1,5,7,10..11      ; 2214
.shutter 1000101001110 1,5,7,10..12      ; 2215
.shutter 1000101010000 1,5,7,9           ; 2216
.shutter 1000101010010 1,5..9/2,12       ; 2217
.shutter 1000101010100 1,5..11/2         ; 2218
.shutter 1000101010110 1,5..11/2,12      ; 2219
.shutter 1000101011000 1,5,7,9..10       ; 2220
.shutter 1000101011010 1,5..9/2,10,12    ; 2221
.shutter 1000101011100 1,5,7,9..11       ; 2222
.shutter 1000101011110 1,5,7,9..12       ; 2223
.shutter 1000101100000 1,5,7..8          ; 2224
.shutter 1000101100010 1,5,7..8,12       ; 2225
.shutter 1000101100100 1,5,7..8,11       ; 2226
.shutter 1000101100110 1,5,7..8,11..12   ; 2227
.shutter 1000101101000 1,5,7..8,10       ; 2228
.shutter 1000101101010 1,5,7..8,10,12    ; 2229
.shutter 1000101101100 1,5,7..8,10..11   ; 2230
.shutter 1000101101110 1,5,7..8,10..12   ; 2231
.shutter 1000101110000 1,5,7..9          ; 2232
.shutter 1000101110010 1,5,7..9,12       ; 2233
.shutter 1000101110100 1,5,7..9,11       ; 2234
.shutter 1000101110110 1,5,7..9,11..12   ; 2235
.shutter 1000101111000 1,5,7..10         ; 2236
.shutter 1000101111010 1,5,7..10,12      ; 2237
.shutter 1000101111100 1,5,7..11         ; 2238
.shutter 1000101111110 1,5,7..12         ; 2239
.shutter 1000110000000 1,5..6            ; 2240
.shutter 1000110000010 1,5..6,12         ; 2241
.shutter 1000110000100 1,5..6,11         ; 2242
.shutter 1000110000110 1,5..6,11..12     ; 2243
.shutter 1000110001000 1,5..6,10         ; 2244
.shutter 1000110001010 1,5..6,10,12      ; 2245
.shutter 1000110001100 1,5..6,10..11     ; 2246
.shutter 1000110001110 1,5..6,10..12     ; 2247
.shutter 1000110010000 1,5..6,9          ; 2248
.shutter 1000110010010 1,5..6,9,12       ; 2249
.shutter 1000110010100 1,5..6,9,11       ; 2250
.shutter 1000110010110 1,5..6,9,11..12   ; 2251
.shutter 1000110011000 1,5..6,9..10      ; 2252
.shutter 1000110011010 1,5..6,9..10,12   ; 2253
.shutter 1000110011100 1,5..6,9..11      ; 2254
.shutter 1000110011110 1,5..6,9..12      ; 2255
.shutter 1000110100000 1,5..6,8          ; 2256
.shutter 1000110100010 1,5..6,8,12       ; 2257
.shutter 1000110100100 1,5..6,8,11       ; 2258
.shutter 1000110100110 1,5..6,8,11..12   ; 2259
.shutter 1000110101000 1,5..6,8,10       ; 2260
.shutter 1000110101010 1,5..6,8..12/2    ; 2261
.shutter 1000110101100 1,5..6,8,10..11   ; 2262
.shutter 1000110101110 1,5..6,8,10..12   ; 2263
.shutter 1000110110000 1,5..6,8..9       ; 2264
.shutter 1000110110010 1,5..6,8..9,12    ; 2265
.shutter 1000110110100 1,5..6,8..9,11    ; 2266
.shutter 1000110110110 1,5..6,8..9,11..12 ; 2267
.shutter 1000110111000 1,5..6,8..10      ; 2268
.shutter 1000110111010 1,5..6,8..10,12   ; 2269
.shutter 1000110111100 1,5..6,8..11      ; 2270
.shutter 1000110111110 1,5..6,8..12      ; 2271
.shutter 1000111000000 1,5..7            ; 2272
.shutter 1000111000010 1,5..7,12         ; 2273
.shutter 1000111000100 1,5..7,11         ; 2274
.shutter 1000111000110 1,5..7,11..12     ; 2275
.shutter 1000111001000 1,5..7,10         ; 2276
.shutter 1000111001010 1,5..7,10,12      ; 2277
.shutter 1000111001100 1,5..7,10..11     ; 2278
.shutter 1000111001110 1,5..7,10..12     ; 2279
.shutter 1000111010000 1,5..7,9          ; 2280
.shutter 1000111010010 1,5..7,9,12       ; 2281
.shutter 1000111010100 1,5..7,9,11       ; 2282
.shutter 1000111010110 1,5..7,9,11..12   ; 2283
.shutter 1000111011000 1,5..7,9..10      ; 2284
.shutter 1000111011010 1,5..7,9..10,12   ; 2285
.shutter 1000111011100 1,5..7,9..11      ; 2286
.shutter 1000111011110 1,5..7,9..12      ; 2287
.shutter 1000111100000 1,5..8            ; 2288
.shutter 1000111100010 1,5..8,12         ; 2289
.shutter 1000111100100 1,5..8,11         ; 2290
.shutter 1000111100110 1,5..8,11..12     ; 2291
.shutter 1000111101000 1,5..8,10         ; 2292
.shutter 1000111101010 1,5..8,10,12      ; 2293
.shutter 1000111101100 1,5..8,10..11     ; 2294
.shutter 1000111101110 1,5..8,10..12     ; 2295
.shutter 1000111110000 1,5..9            ; 2296
.shutter 1000111110010 1,5..9,12         ; 2297
.shutter 1000111110100 1,5..9,11         ; 2298
.shutter 1000111110110 1,5..9,11..12     ; 2299
.shutter 1000111111000 1,5..10           ; 2300
.shutter 1000111111010 1,5..10,12        ; 2301
.shutter 1000111111100 1,5..11           ; 2302
.shutter 1000111111110 1,5..12           ; 2303
.shutter 1001000000000 1,4               ; 2304
.shutter 1001000000010 1,4,12            ; 2305
.shutter 1001000000100 1,4,11            ; 2306
.shutter 1001000000110 1,4,11..12        ; 2307
.shutter 1001000001000 1,4,10            ; 2308
.shutter 1001000001010 1,4,10,12         ; 2309
.shutter 1001000001100 1,4,10..11        ; 2310
.shutter 1001000001110 1,4,10..12        ; 2311
.shutter 1001000010000 1,4,9             ; 2312
.shutter 1001000010010 1,4,9,12          ; 2313
.shutter 1001000010100 1,4,9,11          ; 2314
.shutter 1001000010110 1,4,9,11..12      ; 2315
.shutter 1001000011000 1,4,9..10         ; 2316
.shutter 1001000011010 1,4,9..10,12      ; 2317
.shutter 1001000011100 1,4,9..11         ; 2318
.shutter 1001000011110 1,4,9..12         ; 2319
.shutter 1001000100000 1,4,8             ; 2320
.shutter 1001000100010 1,4,8,12          ; 2321
.shutter 1001000100100 1,4,8,11          ; 2322
.shutter 1001000100110 1,4,8,11..12      ; 2323
.shutter 1001000101000 1,4,8,10          ; 2324
.shutter 1001000101010 1,4,8..12/2       ; 2325
.shutter 1001000101100 1,4,8,10..11      ; 2326
.shutter 1001000101110 1,4,8,10..12      ; 2327
.shutter 1001000110000 1,4,8..9          ; 2328
.shutter 1001000110010 1,4,8..9,12       ; 2329
.shutter 1001000110100 1,4,8..9,11       ; 2330
.shutter 1001000110110 1,4,8..9,11..12   ; 2331
.shutter 1001000111000 1,4,8..10         ; 2332
.shutter 1001000111010 1,4,8..10,12      ; 2333
.shutter 1001000111100 1,4,8..11         ; 2334
.shutter 1001000111110 1,4,8..12         ; 2335
.shutter 1001001000000 1,4,7             ; 2336
.shutter 1001001000010 1,4,7,12          ; 2337
.shutter 1001001000100 1,4,7,11          ; 2338
.shutter 1001001000110 1,4,7,11..12      ; 2339
.shutter 1001001001000 1,4,7,10          ; 2340
.shutter 1001001001010 1..10/3,12        ; 2341
.shutter 1001001001100 1,4,7,10..11      ; 2342
.shutter 1001001001110 1,4,7,10..12      ; 2343
.shutter 1001001010000 1,4,7,9           ; 2344
.shutter 1001001010010 1..7/3,9,12       ; 2345
.shutter 1001001010100 1..7/3,9,11       ; 2346
.shutter 1001001010110 1..7/3,9,11..12   ; 2347
.shutter 1001001011000 1,4,7,9..10       ; 2348
.shutter 1001001011010 1..7/3,9..10,12   ; 2349
.shutter 1001001011100 1,4,7,9..11       ; 2350
.shutter 1001001011110 1,4,7,9..12       ; 2351
.shutter 1001001100000 1,4,7..8          ; 2352
.shutter 1001001100010 1,4,7..8,12       ; 2353
.shutter 1001001100100 1,4,7..8,11       ; 2354
.shutter 1001001100110 1,4,7..8,11..12   ; 2355
.shutter 1001001101000 1,4,7..8,10       ; 2356
.shutter 1001001101010 1..7/3,8..12/2    ; 2357
.shutter 1001001101100 1,4,7..8,10..11   ; 2358
.shutter 1001001101110 1,4,7..8,10..12   ; 2359
.shutter 1001001110000 1,4,7..9          ; 2360
.shutter 1001001110010 1,4,7..9,12       ; 2361
.shutter 1001001110100 1,4,7..9,11       ; 2362
.shutter 1001001110110 1,4,7..9,11..12   ; 2363
.shutter 1001001111000 1,4,7..10         ; 2364
.shutter 1001001111010 1,4,7..10,12      ; 2365
.shutter 1001001111100 1,4,7..11         ; 2366
.shutter 1001001111110 1,4,7..12         ; 2367
.shutter 1001010000000 1,4,6             ; 2368
.shutter 1001010000010 1,4,6,12          ; 2369
.shutter 1001010000100 1,4,6,11          ; 2370
.shutter 1001010000110 1,4,6,11..12      ; 2371
.shutter 1001010001000 1,4,6,10          ; 2372
.shutter 1001010001010 1,4,6,10,12       ; 2373
.shutter 1001010001100 1,4,6,10..11      ; 2374
.shutter 1001010001110 1,4,6,10..12      ; 2375
.shutter 1001010010000 1,4,6,9           ; 2376
.shutter 1001010010010 1,4,6..12/3       ; 2377
.shutter 1001010010100 1,4,6,9,11        ; 2378
.shutter 1001010010110 1,4,6,9,11..12    ; 2379
.shutter 1001010011000 1,4,6,9..10       ; 2380
.shutter 1001010011010 1,4,6,9..10,12    ; 2381
.shutter 1001010011100 1,4,6,9..11       ; 2382
.shutter 1001010011110 1,4,6,9..12       ; 2383
.shutter 1001010100000 1,4,6,8           ; 2384
.shutter 1001010100010 1,4..8/2,12       ; 2385
.shutter 1001010100100 1,4..8/2,11       ; 2386
.shutter 1001010100110 1,4..8/2,11..12   ; 2387
.shutter 1001010101000 1,4..10/2         ; 2388
.shutter 1001010101010 1,4..12/2         ; 2389
.shutter 1001010101100 1,4..10/2,11      ; 2390
.shutter 1001010101110 1,4..10/2,11..12  ; 2391
.shutter 1001010110000 1,4,6,8..9        ; 2392
.shutter 1001010110010 1,4..8/2,9,12     ; 2393
.shutter 1001010110100 1,4..8/2,9,11     ; 2394
.shutter 1001010110110 1,4..8/2,9,11..12 ; 2395
.shutter 1001010111000 1,4,6,8..10       ; 2396
.shutter 1001010111010 1,4..8/2,9..10,12 ; 2397
.shutter 1001010111100 1,4,6,8..11       ; 2398
.shutter 1001010111110 1,4,6,8..12       ; 2399
.shutter 1001011000000 1,4,6..7          ; 2400
.shutter 1001011000010 1,4,6..7,12       ; 2401
.shutter 1001011000100 1,4,6..7,11       ; 2402
.shutter 1001011000110 1,4,6..7,11..12   ; 2403
.shutter 1001011001000 1,4,6..7,10       ; 2404
.shutter 1001011001010 1,4,6..7,10,12    ; 2405
.shutter 1001011001100 1,4,6..7,10..11   ; 2406
.shutter 1001011001110 1,4,6..7,10..12   ; 2407
.shutter 1001011010000 1,4,6..7,9        ; 2408
.shutter 1001011010010 1,4,6..7,9,12     ; 2409
.shutter 1001011010100 1,4,6..7,9,11     ; 2410
.shutter 1001011010110 1,4,6..7,9,11..12 ; 2411
.shutter 1001011011000 1,4,6..7,9..10    ; 2412
.shutter 1001011011010 1,4,6..7,9..10,12 ; 2413
.shutter 1001011011100 1,4,6..7,9..11    ; 2414
.shutter 1001011011110 1,4,6..7,9..12    ; 2415
.shutter 1001011100000 1,4,6..8          ; 2416
.shutter 1001011100010 1,4,6..8,12       ; 2417
.shutter 1001011100100 1,4,6..8,11       ; 2418
.shutter 1001011100110 1,4,6..8,11..12   ; 2419
.shutter 1001011101000 1,4,6..8,10       ; 2420
.shutter 1001011101010 1,4,6..8,10,12    ; 2421
.shutter 1001011101100 1,4,6..8,10..11   ; 2422
.shutter 1001011101110 1,4,6..8,10..12   ; 2423
.shutter 1001011110000 1,4,6..9          ; 2424
.shutter 1001011110010 1,4,6..9,12       ; 2425
.shutter 1001011110100 1,4,6..9,11       ; 2426
.shutter 1001011110110 1,4,6..9,11..12   ; 2427
.shutter 1001011111000 1,4,6..10         ; 2428
.shutter 1001011111010 1,4,6..10,12      ; 2429
.shutter 1001011111100 1,4,6..11         ; 2430
.shutter 1001011111110 1,4,6..12         ; 2431
.shutter 1001100000000 1,4..5            ; 2432
.shutter 1001100000010 1,4..5,12         ; 2433
.shutter 1001100000100 1,4..5,11         ; 2434
.shutter 1001100000110 1,4..5,11..12     ; 2435
.shutter 1001100001000 1,4..5,10         ; 2436
.shutter 1001100001010 1,4..5,10,12      ; 2437
.shutter 1001100001100 1,4..5,10..11     ; 2438
.shutter 1001100001110 1,4..5,10..12     ; 2439
.shutter 1001100010000 1,4..5,9          ; 2440
.shutter 1001100010010 1,4..5,9,12       ; 2441
.shutter 1001100010100 1,4..5,9,11       ; 2442
.shutter 1001100010110 1,4..5,9,11..12   ; 2443
.shutter 1001100011000 1,4..5,9..10      ; 2444
.shutter 1001100011010 1,4..5,9..10,12   ; 2445
.shutter 1001100011100 1,4..5,9..11      ; 2446
.shutter 1001100011110 1,4..5,9..12      ; 2447
.shutter 1001100100000 1,4..5,8          ; 2448
.shutter 1001100100010 1,4..5,8,12       ; 2449
.shutter 1001100100100 1,4..5,8,11       ; 2450
.shutter 1001100100110 1,4..5,8,11..12   ; 2451
.shutter 1001100101000 1,4..5,8,10       ; 2452
.shutter 1001100101010 1,4..5,8..12/2    ; 2453
.shutter 1001100101100 1,4..5,8,10..11   ; 2454
.shutter 1001100101110 1,4..5,8,10..12   ; 2455
.shutter 1001100110000 1,4..5,8..9       ; 2456
.shutter 1001100110010 1,4..5,8..9,12    ; 2457
.shutter 1001100110100 1,4..5,8..9,11    ; 2458
.shutter 1001100110110 1,4..5,8..9,11..12 ; 2459
.shutter 1001100111000 1,4..5,8..10      ; 2460
.shutter 1001100111010 1,4..5,8..10,12   ; 2461
.shutter 1001100111100 1,4..5,8..11      ; 2462
.shutter 1001100111110 1,4..5,8..12      ; 2463
.shutter 1001101000000 1,4..5,7          ; 2464
.shutter 1001101000010 1,4..5,7,12       ; 2465
.shutter 1001101000100 1,4..5,7,11       ; 2466
.shutter 1001101000110 1,4..5,7,11..12   ; 2467
.shutter 1001101001000 1,4..5,7,10       ; 2468
.shutter 1001101001010 1,4..5,7,10,12    ; 2469
.shutter 1001101001100 1,4..5,7,10..11   ; 2470
.shutter 1001101001110 1,4..5,7,10..12   ; 2471
.shutter 1001101010000 1,4..5,7,9        ; 2472
.shutter 1001101010010 1,4..5,7,9,12     ; 2473
.shutter 1001101010100 1,4..5,7..11/2    ; 2474
.shutter 1001101010110 1,4..5,7..11/2,12 ; 2475
.shutter 1001101011000 1,4..5,7,9..10    ; 2476
.shutter 1001101011010 1,4..5,7,9..10,12 ; 2477
.shutter 1001101011100 1,4..5,7,9..11    ; 2478
.shutter 1001101011110 1,4..5,7,9..12    ; 2479
.shutter 1001101100000 1,4..5,7..8       ; 2480
.shutter 1001101100010 1,4..5,7..8,12    ; 2481
.shutter 1001101100100 1,4..5,7..8,11    ; 2482
.shutter 1001101100110 1,4..5,7..8,11..12 ; 2483
.shutter 1001101101000 1,4..5,7..8,10    ; 2484
.shutter 1001101101010 1,4..5,7..8,10,12 ; 2485
.shutter 1001101101100 1,4..5,7..8,10..11 ; 2486
.shutter 1001101101110 1,4..5,7..8,10..12 ; 2487
.shutter 1001101110000 1,4..5,7..9       ; 2488
.shutter 1001101110010 1,4..5,7..9,12    ; 2489
.shutter 1001101110100 1,4..5,7..9,11    ; 2490
.shutter 1001101110110 1,4..5,7..9,11..12 ; 2491
.shutter 1001101111000 1,4..5,7..10      ; 2492
.shutter 1001101111010 1,4..5,7..10,12   ; 2493
.shutter 1001101111100 1,4..5,7..11      ; 2494
.shutter 1001101111110 1,4..5,7..12      ; 2495
.shutter 1001110000000 1,4..6            ; 2496
.shutter 1001110000010 1,4..6,12         ; 2497
.shutter 1001110000100 1,4..6,11         ; 2498
.shutter 1001110000110 1,4..6,11..12     ; 2499
.shutter 1001110001000 1,4..6,10         ; 2500
.shutter 1001110001010 1,4..6,10,12      ; 2501
.shutter 1001110001100 1,4..6,10..11     ; 2502
.shutter 1001110001110 1,4..6,10..12     ; 2503
.shutter 1001110010000 1,4..6,9          ; 2504
.shutter 1001110010010 1,4..6,9,12       ; 2505
.shutter 1001110010100 1,4..6,9,11       ; 2506
.shutter 1001110010110 1,4..6,9,11..12   ; 2507
.shutter 1001110011000 1,4..6,9..10      ; 2508
.shutter 1001110011010 1,4..6,9..10,12   ; 2509
.shutter 1001110011100 1,4..6,9..11      ; 2510
.shutter 1001110011110 1,4..6,9..12      ; 2511
.shutter 1001110100000 1,4..6,8          ; 2512
.shutter 1001110100010 1,4..6,8,12       ; 2513
.shutter 1001110100100 1,4..6,8,11       ; 2514
.shutter 1001110100110 1,4..6,8,11..12   ; 2515
.shutter 1001110101000 1,4..6,8,10       ; 2516
.shutter 1001110101010 1,4..6,8..12/2    ; 2517
.shutter 1001110101100 1,4..6,8,10..11   ; 2518
.shutter 1001110101110 1,4..6,8,10..12   ; 2519
.shutter 1001110110000 1,4..6,8..9       ; 2520
.shutter 1001110110010 1,4..6,8..9,12    ; 2521
.shutter 1001110110100 1,4..6,8..9,11    ; 2522
.shutter 1001110110110 1,4..6,8..9,11..12 ; 2523
.shutter 1001110111000 1,4..6,8..10      ; 2524
.shutter 1001110111010 1,4..6,8..10,12   ; 2525
.shutter 1001110111100 1,4..6,8..11      ; 2526
.shutter 1001110111110 1,4..6,8..12      ; 2527
.shutter 1001111000000 1,4..7            ; 2528
.shutter 1001111000010 1,4..7,12         ; 2529
.shutter 1001111000100 1,4..7,11         ; 2530
.shutter 1001111000110 1,4..7,11..12     ; 2531
.shutter 1001111001000 1,4..7,10         ; 2532
.shutter 1001111001010 1,4..7,10,12      ; 2533
.shutter 1001111001100 1,4..7,10..11     ; 2534
.shutter 1001111001110 1,4..7,10..12     ; 2535
.shutter 1001111010000 1,4..7,9          ; 2536
.shutter 1001111010010 1,4..7,9,12       ; 2537
.shutter 1001111010100 1,4..7,9,11       ; 2538
.shutter 1001111010110 1,4..7,9,11..12   ; 2539
.shutter 1001111011000 1,4..7,9..10      ; 2540
.shutter 1001111011010 1,4..7,9..10,12   ; 2541
.shutter 1001111011100 1,4..7,9..11      ; 2542
.shutter 1001111011110 1,4..7,9..12      ; 2543
.shutter 1001111100000 1,4..8            ; 2544
.shutter 1001111100010 1,4..8,12         ; 2545
.shutter 1001111100100 1,4..8,11         ; 2546
.shutter 1001111100110 1,4..8,11..12     ; 2547
.shutter 1001111101000 1,4..8,10         ; 2548
.shutter 1001111101010 1,4..8,10,12      ; 2549
.shutter 1001111101100 1,4..8,10..11     ; 2550
.shutter 1001111101110 1,4..8,10..12     ; 2551
.shutter 1001111110000 1,4..9            ; 2552
.shutter 1001111110010 1,4..9,12         ; 2553
.shutter 1001111110100 1,4..9,11         ; 2554
.shutter 1001111110110 1,4..9,11..12     ; 2555
.shutter 1001111111000 1,4..10           ; 2556
.shutter 1001111111010 1,4..10,12        ; 2557
.shutter 1001111111100 1,4..11           ; 2558
.shutter 1001111111110 1,4..12           ; 2559
.shutter 1010000000000 1,3               ; 2560
.shutter 1010000000010 1,3,12            ; 2561
.shutter 1010000000100 1,3,11            ; 2562
.shutter 1010000000110 1,3,11..12        ; 2563
.shutter 1010000001000 1,3,10            ; 2564
.shutter 1010000001010 1,3,10,12         ; 2565
.shutter 1010000001100 1,3,10..11        ; 2566
.shutter 1010000001110 1,3,10..12        ; 2567
.shutter 1010000010000 1,3,9             ; 2568
.shutter 1010000010010 1,3,9,12          ; 2569
.shutter 1010000010100 1,3,9,11          ; 2570
.shutter 1010000010110 1,3,9,11..12      ; 2571
.shutter 1010000011000 1,3,9..10         ; 2572
.shutter 1010000011010 1,3,9..10,12      ; 2573
.shutter 1010000011100 1,3,9..11         ; 2574
.shutter 1010000011110 1,3,9..12         ; 2575
.shutter 1010000100000 1,3,8             ; 2576
.shutter 1010000100010 1,3,8,12          ; 2577
.shutter 1010000100100 1,3,8,11          ; 2578
.shutter 1010000100110 1,3,8,11..12      ; 2579
.shutter 1010000101000 1,3,8,10          ; 2580
.shutter 1010000101010 1,3,8..12/2       ; 2581
.shutter 1010000101100 1,3,8,10..11      ; 2582
.shutter 1010000101110 1,3,8,10..12      ; 2583
.shutter 1010000110000 1,3,8..9          ; 2584
.shutter 1010000110010 1,3,8..9,12       ; 2585
.shutter 1010000110100 1,3,8..9,11       ; 2586
.shutter 1010000110110 1,3,8..9,11..12   ; 2587
.shutter 1010000111000 1,3,8..10         ; 2588
.shutter 1010000111010 1,3,8..10,12      ; 2589
.shutter 1010000111100 1,3,8..11         ; 2590
.shutter 1010000111110 1,3,8..12         ; 2591
.shutter 1010001000000 1,3,7             ; 2592
.shutter 1010001000010 1,3,7,12          ; 2593
.shutter 1010001000100 1,3,7,11          ; 2594
.shutter 1010001000110 1,3,7,11..12      ; 2595
.shutter 1010001001000 1,3,7,10          ; 2596
.shutter 1010001001010 1,3,7,10,12       ; 2597
.shutter 1010001001100 1,3,7,10..11      ; 2598
.shutter 1010001001110 1,3,7,10..12      ; 2599
.shutter 1010001010000 1,3,7,9           ; 2600
.shutter 1010001010010 1,3,7,9,12        ; 2601
.shutter 1010001010100 1,3,7..11/2       ; 2602
.shutter 1010001010110 1,3,7..11/2,12    ; 2603
.shutter 1010001011000 1,3,7,9..10       ; 2604
.shutter 1010001011010 1,3,7,9..10,12    ; 2605
.shutter 1010001011100 1,3,7,9..11       ; 2606
.shutter 1010001011110 1,3,7,9..12       ; 2607
.shutter 1010001100000 1,3,7..8          ; 2608
.shutter 1010001100010 1,3,7..8,12       ; 2609
.shutter 1010001100100 1,3,7..8,11       ; 2610
.shutter 1010001100110 1,3,7..8,11..12   ; 2611
.shutter 1010001101000 1,3,7..8,10       ; 2612
.shutter 1010001101010 1,3,7..8,10,12    ; 2613
.shutter 1010001101100 1,3,7..8,10..11   ; 2614
.shutter 1010001101110 1,3,7..8,10..12   ; 2615
.shutter 1010001110000 1,3,7..9          ; 2616
.shutter 1010001110010 1,3,7..9,12       ; 2617
.shutter 1010001110100 1,3,7..9,11       ; 2618
.shutter 1010001110110 1,3,7..9,11..12   ; 2619
.shutter 1010001111000 1,3,7..10         ; 2620
.shutter 1010001111010 1,3,7..10,12      ; 2621
.shutter 1010001111100 1,3,7..11         ; 2622
.shutter 1010001111110 1,3,7..12         ; 2623
.shutter 1010010000000 1,3,6             ; 2624
.shutter 1010010000010 1,3,6,12          ; 2625
.shutter 1010010000100 1,3,6,11          ; 2626
.shutter 1010010000110 1,3,6,11..12      ; 2627
.shutter 1010010001000 1,3,6,10          ; 2628
.shutter 1010010001010 1,3,6,10,12       ; 2629
.shutter 1010010001100 1,3,6,10..11      ; 2630
.shutter 1010010001110 1,3,6,10..12      ; 2631
.shutter 1010010010000 1,3,6,9           ; 2632
.shutter 1010010010010 1,3..12/3         ; 2633
.shutter 1010010010100 1,3..9/3,11       ; 2634
.shutter 1010010010110 1,3..9/3,11..12   ; 2635
.shutter 1010010011000 1,3,6,9..10       ; 2636
.shutter 1010010011010 1,3..9/3,10,12    ; 2637
.shutter 1010010011100 1,3,6,9..11       ; 2638
.shutter 1010010011110 1,3,6,9..12       ; 2639
.shutter 1010010100000 1,3,6,8           ; 2640
.shutter 1010010100010 1,3,6,8,12        ; 2641
.shutter 1010010100100 1,3,6,8,11        ; 2642
.shutter 1010010100110 1,3,6,8,11..12    ; 2643
.shutter 1010010101000 1,3,6..10/2       ; 2644
.shutter 1010010101010 1,3,6..12/2       ; 2645
.shutter 1010010101100 1,3,6..10/2,11    ; 2646
.shutter 1010010101110 1,3,6..10/2,11..12 ; 2647
.shutter 1010010110000 1,3,6,8..9        ; 2648
.shutter 1010010110010 1,3,6,8..9,12     ; 2649
.shutter 1010010110100 1,3,6,8..9,11     ; 2650
.shutter 1010010110110 1,3,6,8..9,11..12 ; 2651
.shutter 1010010111000 1,3,6,8..10       ; 2652
.shutter 1010010111010 1,3,6,8..10,12    ; 2653
.shutter 1010010111100 1,3,6,8..11       ; 2654
.shutter 1010010111110 1,3,6,8..12       ; 2655
.shutter 1010011000000 1,3,6..7          ; 2656
.shutter 1010011000010 1,3,6..7,12       ; 2657
.shutter 1010011000100 1,3,6..7,11       ; 2658
.shutter 1010011000110 1,3,6..7,11..12   ; 2659
.shutter 1010011001000 1,3,6..7,10       ; 2660
.shutter 1010011001010 1,3,6..7,10,12    ; 2661
.shutter 1010011001100 1,3,6..7,10..11   ; 2662
.shutter 1010011001110 1,3,6..7,10..12   ; 2663
.shutter 1010011010000 1,3,6..7,9        ; 2664
.shutter 1010011010010 1,3,6..7,9,12     ; 2665
.shutter 1010011010100 1,3,6..7,9,11     ; 2666
.shutter 1010011010110 1,3,6..7,9,11..12 ; 2667
.shutter 1010011011000 1,3,6..7,9..10    ; 2668
.shutter 1010011011010 1,3,6..7,9..10,12 ; 2669
.shutter 1010011011100 1,3,6..7,9..11    ; 2670
.shutter 1010011011110 1,3,6..7,9..12    ; 2671
.shutter 1010011100000 1,3,6..8          ; 2672
.shutter 1010011100010 1,3,6..8,12       ; 2673
.shutter 1010011100100 1,3,6..8,11       ; 2674
.shutter 1010011100110 1,3,6..8,11..12   ; 2675
.shutter 1010011101000 1,3,6..8,10       ; 2676
.shutter 1010011101010 1,3,6..8,10,12    ; 2677
.shutter 1010011101100 1,3,6..8,10..11   ; 2678
.shutter 1010011101110 1,3,6..8,10..12   ; 2679
.shutter 1010011110000 1,3,6..9          ; 2680
.shutter 1010011110010 1,3,6..9,12       ; 2681
.shutter 1010011110100 1,3,6..9,11       ; 2682
.shutter 1010011110110 1,3,6..9,11..12   ; 2683
.shutter 1010011111000 1,3,6..10         ; 2684
.shutter 1010011111010 1,3,6..10,12      ; 2685
.shutter 1010011111100 1,3,6..11         ; 2686
.shutter 1010011111110 1,3,6..12         ; 2687
.shutter 1010100000000 1,3,5             ; 2688
.shutter 1010100000010 1,3,5,12          ; 2689
.shutter 1010100000100 1,3,5,11          ; 2690
.shutter 1010100000110 1,3,5,11..12      ; 2691
.shutter 1010100001000 1,3,5,10          ; 2692
.shutter 1010100001010 1..5/2,10,12      ; 2693
.shutter 1010100001100 1,3,5,10..11      ; 2694
.shutter 1010100001110 1,3,5,10..12      ; 2695
.shutter 1010100010000 1,3,5,9           ; 2696
.shutter 1010100010010 1..5/2,9,12       ; 2697
.shutter 1010100010100 1..5/2,9,11       ; 2698
.shutter 1010100010110 1..5/2,9,11..12   ; 2699
.shutter 1010100011000 1,3,5,9..10       ; 2700
.shutter 1010100011010 1..5/2,9..10,12   ; 2701
.shutter 1010100011100 1,3,5,9..11       ; 2702
.shutter 1010100011110 1,3,5,9..12       ; 2703
.shutter 1010100100000 1,3,5,8           ; 2704
.shutter 1010100100010 1..5/2,8,12       ; 2705
.shutter 1010100100100 1..5/2,8,11       ; 2706
.shutter 1010100100110 1..5/2,8,11..12   ; 2707
.shutter 1010100101000 1..5/2,8,10       ; 2708
.shutter 1010100101010 1..5/2,8..12/2    ; 2709
.shutter 1010100101100 1..5/2,8,10..11   ; 2710
.shutter 1010100101110 1..5/2,8,10..12   ; 2711
.shutter 1010100110000 1,3,5,8..9        ; 2712
.shutter 1010100110010 1..5/2,8..9,12    ; 2713
.shutter 1010100110100 1..5/2,8..9,11    ; 2714
.shutter 1010100110110 1..5/2,8..9,11..12 ; 2715
.shutter 1010100111000 1,3,5,8..10       ; 2716
.shutter 1010100111010 1..5/2,8..10,12   ; 2717
.shutter 1010100111100 1,3,5,8..11       ; 2718
.shutter 1010100111110 1,3,5,8..12       ; 2719
.shutter 1010101000000 1,3,5,7           ; 2720
.shutter 1010101000010 1..7/2,12         ; 2721
.shutter 1010101000100 1..7/2,11         ; 2722
.shutter 1010101000110 1..7/2,11..12     ; 2723
.shutter 1010101001000 1..7/2,10         ; 2724
.shutter 1010101001010 1..7/2,10,12      ; 2725
.shutter 1010101001100 1..7/2,10..11     ; 2726
.shutter 1010101001110 1..7/2,10..12     ; 2727
.shutter 1010101010000 1..9/2            ; 2728
.shutter 1010101010010 1..9/2,12         ; 2729
.shutter 1010101010100 1..11/2           ; 2730
.shutter 1010101010110 1..11/2,12        ; 2731
.shutter 1010101011000 1..9/2,10         ; 2732
.shutter 1010101011010 1..9/2,10,12      ; 2733
.shutter 1010101011100 1..9/2,10..11     ; 2734
.shutter 1010101011110 1..9/2,10..12     ; 2735
.shutter 1010101100000 1,3,5,7..8        ; 2736
.shutter 1010101100010 1..7/2,8,12       ; 2737
.shutter 1010101100100 1..7/2,8,11       ; 2738
.shutter 1010101100110 1..7/2,8,11..12   ; 2739
.shutter 1010101101000 1..7/2,8,10       ; 2740
.shutter 1010101101010 1..7/2,8..12/2    ; 2741
.shutter 1010101101100 1..7/2,8,10..11   ; 2742
.shutter 1010101101110 1..7/2,8,10..12   ; 2743
.shutter 1010101110000 1,3,5,7..9        ; 2744
.shutter 1010101110010 1..7/2,8..9,12    ; 2745
.shutter 1010101110100 1..7/2,8..9,11    ; 2746
.shutter 1010101110110 1..7/2,8..9,11..12 ; 2747
.shutter 1010101111000 1,3,5,7..10       ; 2748
.shutter 1010101111010 1..7/2,8..10,12   ; 2749
.shutter 1010101111100 1,3,5,7..11       ; 2750
.shutter 1010101111110 1,3,5,7..12       ; 2751
.shutter 1010110000000 1,3,5..6          ; 2752
.shutter 1010110000010 1,3,5..6,12       ; 2753
.shutter 1010110000100 1,3,5..6,11       ; 2754
.shutter 1010110000110 1,3,5..6,11..12   ; 2755
.shutter 1010110001000 1,3,5..6,10       ; 2756
.shutter 1010110001010 1..5/2,6,10,12    ; 2757
.shutter 1010110001100 1,3,5..6,10..11   ; 2758
.shutter 1010110001110 1,3,5..6,10..12   ; 2759
.shutter 1010110010000 1,3,5..6,9        ; 2760
.shutter 1010110010010 1..5/2,6..12/3    ; 2761
.shutter 1010110010100 1..5/2,6,9,11     ; 2762
.shutter 1010110010110 1..5/2,6,9,11..12 ; 2763
.shutter 1010110011000 1,3,5..6,9..10    ; 2764
.shutter 1010110011010 1..5/2,6,9..10,12 ; 2765
.shutter 1010110011100 1,3,5..6,9..11    ; 2766
.shutter 1010110011110 1,3,5..6,9..12    ; 2767
.shutter 1010110100000 1,3,5..6,8        ; 2768
.shutter 1010110100010 1..5/2,6,8,12     ; 2769
.shutter 1010110100100 1..5/2,6,8,11     ; 2770
.shutter 1010110100110 1..5/2,6,8,11..12 ; 2771
.shutter 1010110101000 1..5/2,6..10/2    ; 2772
.shutter 1010110101010 1..5/2,6..12/2    ; 2773
.shutter 1010110101100 1..5/2,6..10/2,11 ; 2774
.shutter 1010110101110 x6a1d             ; 2775
.shutter 1010110110000 1,3,5..6,8..9     ; 2776
.shutter 1010110110010 1..5/2,6,8..9,12  ; 2777
.shutter 1010110110100 1..5/2,6,8..9,11  ; 2778
.shutter 1010110110110 1..5/2,6,8..9,11..12 ; 2779
.shutter 1010110111000 1,3,5..6,8..10    ; 2780
.shutter 1010110111010 1..5/2,6,8..10,12 ; 2781
.shutter 1010110111100 1,3,5..6,8..11    ; 2782
.shutter 1010110111110 1,3,5..6,8..12    ; 2783
.shutter 1010111000000 1,3,5..7          ; 2784
.shutter 1010111000010 1,3,5..7,12       ; 2785
.shutter 1010111000100 1,3,5..7,11       ; 2786
.shutter 1010111000110 1,3,5..7,11..12   ; 2787
.shutter 1010111001000 1,3,5..7,10       ; 2788
.shutter 1010111001010 1..5/2,6..7,10,12 ; 2789
.shutter 1010111001100 1,3,5..7,10..11   ; 2790
.shutter 1010111001110 1,3,5..7,10..12   ; 2791
.shutter 1010111010000 1,3,5..7,9        ; 2792
.shutter 1010111010010 1..5/2,6..7,9,12  ; 2793
.shutter 1010111010100 1..5/2,6..7,9,11  ; 2794
.shutter 1010111010110 1..5/2,6..7,9,11..12 ; 2795
.shutter 1010111011000 1,3,5..7,9..10    ; 2796
.shutter 1010111011010 1..5/2,6..7,9..10,12 ; 2797
.shutter 1010111011100 1,3,5..7,9..11    ; 2798
.shutter 1010111011110 1,3,5..7,9..12    ; 2799
.shutter 1010111100000 1,3,5..8          ; 2800
.shutter 1010111100010 1,3,5..8,12       ; 2801
.shutter 1010111100100 1,3,5..8,11       ; 2802
.shutter 1010111100110 1,3,5..8,11..12   ; 2803
.shutter 1010111101000 1,3,5..8,10       ; 2804
.shutter 1010111101010 1..5/2,6..8,10,12 ; 2805
.shutter 1010111101100 1,3,5..8,10..11   ; 2806
.shutter 1010111101110 1,3,5..8,10..12   ; 2807
.shutter 1010111110000 1,3,5..9          ; 2808
.shutter 1010111110010 1,3,5..9,12       ; 2809
.shutter 1010111110100 1,3,5..9,11       ; 2810
.shutter 1010111110110 1,3,5..9,11..12   ; 2811
.shutter 1010111111000 1,3,5..10         ; 2812
.shutter 1010111111010 1,3,5..10,12      ; 2813
.shutter 1010111111100 1,3,5..11         ; 2814
.shutter 1010111111110 1,3,5..12         ; 2815
.shutter 1011000000000 1,3..4            ; 2816
.shutter 1011000000010 1,3..4,12         ; 2817
.shutter 1011000000100 1,3..4,11         ; 2818
.shutter 1011000000110 1,3..4,11..12     ; 2819
.shutter 1011000001000 1,3..4,10         ; 2820
.shutter 1011000001010 1,3..4,10,12      ; 2821
.shutter 1011000001100 1,3..4,10..11     ; 2822
.shutter 1011000001110 1,3..4,10..12     ; 2823
.shutter 1011000010000 1,3..4,9          ; 2824
.shutter 1011000010010 1,3..4,9,12       ; 2825
.shutter 1011000010100 1,3..4,9,11       ; 2826
.shutter 1011000010110 1,3..4,9,11..12   ; 2827
.shutter 1011000011000 1,3..4,9..10      ; 2828
.shutter 1011000011010 1,3..4,9..10,12   ; 2829
.shutter 1011000011100 1,3..4,9..11      ; 2830
.shutter 1011000011110 1,3..4,9..12      ; 2831
.shutter 1011000100000 1,3..4,8          ; 2832
.shutter 1011000100010 1,3..4,8,12       ; 2833
.shutter 1011000100100 1,3..4,8,11       ; 2834
.shutter 1011000100110 1,3..4,8,11..12   ; 2835
.shutter 1011000101000 1,3..4,8,10       ; 2836
.shutter 1011000101010 1,3..4,8..12/2    ; 2837
.shutter 1011000101100 1,3..4,8,10..11   ; 2838
.shutter 1011000101110 1,3..4,8,10..12   ; 2839
.shutter 1011000110000 1,3..4,8..9       ; 2840
.shutter 1011000110010 1,3..4,8..9,12    ; 2841
.shutter 1011000110100 1,3..4,8..9,11    ; 2842
.shutter 1011000110110 1,3..4,8..9,11..12 ; 2843
.shutter 1011000111000 1,3..4,8..10      ; 2844
.shutter 1011000111010 1,3..4,8..10,12   ; 2845
.shutter 1011000111100 1,3..4,8..11      ; 2846
.shutter 1011000111110 1,3..4,8..12      ; 2847
.shutter 1011001000000 1,3..4,7          ; 2848
.shutter 1011001000010 1,3..4,7,12       ; 2849
.shutter 1011001000100 1,3..4,7,11       ; 2850
.shutter 1011001000110 1,3..4,7,11..12   ; 2851
.shutter 1011001001000 1,3..4,7,10       ; 2852
.shutter 1011001001010 1,3..4,7,10,12    ; 2853
.shutter 1011001001100 1,3..4,7,10..11   ; 2854
.shutter 1011001001110 1,3..4,7,10..12   ; 2855
.shutter 1011001010000 1,3..4,7,9        ; 2856
.shutter 1011001010010 1,3..4,7,9,12     ; 2857
.shutter 1011001010100 1,3..4,7..11/2    ; 2858
.shutter 1011001010110 1,3..4,7..11/2,12 ; 2859
.shutter 1011001011000 1,3..4,7,9..10    ; 2860
.shutter 1011001011010 1,3..4,7,9..10,12 ; 2861
.shutter 1011001011100 1,3..4,7,9..11    ; 2862
.shutter 1011001011110 1,3..4,7,9..12    ; 2863
.shutter 1011001100000 1,3..4,7..8       ; 2864
.shutter 1011001100010 1,3..4,7..8,12    ; 2865
.shutter 1011001100100 1,3..4,7..8,11    ; 2866
.shutter 1011001100110 1,3..4,7..8,11..12 ; 2867
.shutter 1011001101000 1,3..4,7..8,10    ; 2868
.shutter 1011001101010 1,3..4,7..8,10,12 ; 2869
.shutter 1011001101100 1,3..4,7..8,10..11 ; 2870
.shutter 1011001101110 1,3..4,7..8,10..12 ; 2871
.shutter 1011001110000 1,3..4,7..9       ; 2872
.shutter 1011001110010 1,3..4,7..9,12    ; 2873
.shutter 1011001110100 1,3..4,7..9,11    ; 2874
.shutter 1011001110110 1,3..4,7..9,11..12 ; 2875
.shutter 1011001111000 1,3..4,7..10      ; 2876
.shutter 1011001111010 1,3..4,7..10,12   ; 2877
.shutter 1011001111100 1,3..4,7..11      ; 2878
.shutter 1011001111110 1,3..4,7..12      ; 2879
.shutter 1011010000000 1,3..4,6          ; 2880
.shutter 1011010000010 1,3..4,6,12       ; 2881
.shutter 1011010000100 1,3..4,6,11       ; 2882
.shutter 1011010000110 1,3..4,6,11..12   ; 2883
.shutter 1011010001000 1,3..4,6,10       ; 2884
.shutter 1011010001010 1,3..4,6,10,12    ; 2885
.shutter 1011010001100 1,3..4,6,10..11   ; 2886
.shutter 1011010001110 1,3..4,6,10..12   ; 2887
.shutter 1011010010000 1,3..4,6,9        ; 2888
.shutter 1011010010010 1,3..4,6..12/3    ; 2889
.shutter 1011010010100 1,3..4,6,9,11     ; 2890
.shutter 1011010010110 1,3..4,6,9,11..12 ; 2891
.shutter 1011010011000 1,3..4,6,9..10    ; 2892
.shutter 1011010011010 1,3..4,6,9..10,12 ; 2893
.shutter 1011010011100 1,3..4,6,9..11    ; 2894
.shutter 1011010011110 1,3..4,6,9..12    ; 2895
.shutter 1011010100000 1,3..4,6,8        ; 2896
.shutter 1011010100010 1,3..4,6,8,12     ; 2897
.shutter 1011010100100 1,3..4,6,8,11     ; 2898
.shutter 1011010100110 1,3..4,6,8,11..12 ; 2899
.shutter 1011010101000 1,3..4,6..10/2    ; 2900
.shutter 1011010101010 1,3..4,6..12/2    ; 2901
.shutter 1011010101100 1,3..4,6..10/2,11 ; 2902
.shutter 1011010101110 x5a1d             ; 2903
.shutter 1011010110000 1,3..4,6,8..9     ; 2904
.shutter 1011010110010 1,3..4,6,8..9,12  ; 2905
.shutter 1011010110100 1,3..4,6,8..9,11  ; 2906
.shutter 1011010110110 1,3..4,6,8..9,11..12 ; 2907
.shutter 1011010111000 1,3..4,6,8..10    ; 2908
.shutter 1011010111010 1,3..4,6,8..10,12 ; 2909
.shutter 1011010111100 1,3..4,6,8..11    ; 2910
.shutter 1011010111110 1,3..4,6,8..12    ; 2911
.shutter 1011011000000 1,3..4,6..7       ; 2912
.shutter 1011011000010 1,3..4,6..7,12    ; 2913
.shutter 1011011000100 1,3..4,6..7,11    ; 2914
.shutter 1011011000110 1,3..4,6..7,11..12 ; 2915
.shutter 1011011001000 1,3..4,6..7,10    ; 2916
.shutter 1011011001010 1,3..4,6..7,10,12 ; 2917
.shutter 1011011001100 1,3..4,6..7,10..11 ; 2918
.shutter 1011011001110 1,3..4,6..7,10..12 ; 2919
.shutter 1011011010000 1,3..4,6..7,9     ; 2920
.shutter 1011011010010 1,3..4,6..7,9,12  ; 2921
.shutter 1011011010100 1,3..4,6..7,9,11  ; 2922
.shutter 1011011010110 1,3..4,6..7,9,11..12 ; 2923
.shutter 1011011011000 1,3..4,6..7,9..10 ; 2924
.shutter 1011011011010 1,3..4,6..7,9..10,12 ; 2925
.shutter 1011011011100 1,3..4,6..7,9..11 ; 2926
.shutter 1011011011110 1,3..4,6..7,9..12 ; 2927
.shutter 1011011100000 1,3..4,6..8       ; 2928
.shutter 1011011100010 1,3..4,6..8,12    ; 2929
.shutter 1011011100100 1,3..4,6..8,11    ; 2930
.shutter 1011011100110 1,3..4,6..8,11..12 ; 2931
.shutter 1011011101000 1,3..4,6..8,10    ; 2932
.shutter 1011011101010 1,3..4,6..8,10,12 ; 2933
.shutter 1011011101100 1,3..4,6..8,10..11 ; 2934
.shutter 1011011101110 1,3..4,6..8,10..12 ; 2935
.shutter 1011011110000 1,3..4,6..9       ; 2936
.shutter 1011011110010 1,3..4,6..9,12    ; 2937
.shutter 1011011110100 1,3..4,6..9,11    ; 2938
.shutter 1011011110110 1,3..4,6..9,11..12 ; 2939
.shutter 1011011111000 1,3..4,6..10      ; 2940
.shutter 1011011111010 1,3..4,6..10,12   ; 2941
.shutter 1011011111100 1,3..4,6..11      ; 2942
.shutter 1011011111110 1,3..4,6..12      ; 2943
.shutter 1011100000000 1,3..5            ; 2944
.shutter 1011100000010 1,3..5,12         ; 2945
.shutter 1011100000100 1,3..5,11         ; 2946
.shutter 1011100000110 1,3..5,11..12     ; 2947
.shutter 1011100001000 1,3..5,10         ; 2948
.shutter 1011100001010 1,3..5,10,12      ; 2949
.shutter 1011100001100 1,3..5,10..11     ; 2950
.shutter 1011100001110 1,3..5,10..12     ; 2951
.shutter 1011100010000 1,3..5,9          ; 2952
.shutter 1011100010010 1,3..5,9,12       ; 2953
.shutter 1011100010100 1,3..5,9,11       ; 2954
.shutter 1011100010110 1,3..5,9,11..12   ; 2955
.shutter 1011100011000 1,3..5,9..10      ; 2956
.shutter 1011100011010 1,3..5,9..10,12   ; 2957
.shutter 1011100011100 1,3..5,9..11      ; 2958
.shutter 1011100011110 1,3..5,9..12      ; 2959
.shutter 1011100100000 1,3..5,8          ; 2960
.shutter 1011100100010 1,3..5,8,12       ; 2961
.shutter 1011100100100 1,3..5,8,11       ; 2962
.shutter 1011100100110 1,3..5,8,11..12   ; 2963
.shutter 1011100101000 1,3..5,8,10       ; 2964
.shutter 1011100101010 1,3..5,8..12/2    ; 2965
.shutter 1011100101100 1,3..5,8,10..11   ; 2966
.shutter 1011100101110 1,3..5,8,10..12   ; 2967
.shutter 1011100110000 1,3..5,8..9       ; 2968
.shutter 1011100110010 1,3..5,8..9,12    ; 2969
.shutter 1011100110100 1,3..5,8..9,11    ; 2970
.shutter 1011100110110 1,3..5,8..9,11..12 ; 2971
.shutter 1011100111000 1,3..5,8..10      ; 2972
.shutter 1011100111010 1,3..5,8..10,12   ; 2973
.shutter 1011100111100 1,3..5,8..11      ; 2974
.shutter 1011100111110 1,3..5,8..12      ; 2975
.shutter 1011101000000 1,3..5,7          ; 2976
.shutter 1011101000010 1,3..5,7,12       ; 2977
.shutter 1011101000100 1,3..5,7,11       ; 2978
.shutter 1011101000110 1,3..5,7,11..12   ; 2979
.shutter 1011101001000 1,3..5,7,10       ; 2980
.shutter 1011101001010 1,3..5,7,10,12    ; 2981
.shutter 1011101001100 1,3..5,7,10..11   ; 2982
.shutter 1011101001110 1,3..5,7,10..12   ; 2983
.shutter 1011101010000 1,3..5,7,9        ; 2984
.shutter 1011101010010 1,3..5,7,9,12     ; 2985
.shutter 1011101010100 1,3..5,7..11/2    ; 2986
.shutter 1011101010110 1,3..5,7..11/2,12 ; 2987
.shutter 1011101011000 1,3..5,7,9..10    ; 2988
.shutter 1011101011010 1,3..5,7,9..10,12 ; 2989
.shutter 1011101011100 1,3..5,7,9..11    ; 2990
.shutter 1011101011110 1,3..5,7,9..12    ; 2991
.shutter 1011101100000 1,3..5,7..8       ; 2992
.shutter 1011101100010 1,3..5,7..8,12    ; 2993
.shutter 1011101100100 1,3..5,7..8,11    ; 2994
.shutter 1011101100110 1,3..5,7..8,11..12 ; 2995
.shutter 1011101101000 1,3..5,7..8,10    ; 2996
.shutter 1011101101010 1,3..5,7..8,10,12 ; 2997
.shutter 1011101101100 1,3..5,7..8,10..11 ; 2998
.shutter 1011101101110 1,3..5,7..8,10..12 ; 2999
.shutter 1011101110000 1,3..5,7..9       ; 3000
.shutter 1011101110010 1,3..5,7..9,12    ; 3001
.shutter 1011101110100 1,3..5,7..9,11    ; 3002
.shutter 1011101110110 1,3..5,7..9,11..12 ; 3003
.shutter 1011101111000 1,3..5,7..10      ; 3004
.shutter 1011101111010 1,3..5,7..10,12   ; 3005
.shutter 1011101111100 1,3..5,7..11      ; 3006
.shutter 1011101111110 1,3..5,7..12      ; 3007
.shutter 1011110000000 1,3..6            ; 3008
.shutter 1011110000010 1,3..6,12         ; 3009
.shutter 1011110000100 1,3..6,11         ; 3010
.shutter 1011110000110 1,3..6,11..12     ; 3011
.shutter 1011110001000 1,3..6,10         ; 3012
.shutter 1011110001010 1,3..6,10,12      ; 3013
.shutter 1011110001100 1,3..6,10..11     ; 3014
.shutter 1011110001110 1,3..6,10..12     ; 3015
.shutter 1011110010000 1,3..6,9          ; 3016
.shutter 1011110010010 1,3..6,9,12       ; 3017
.shutter 1011110010100 1,3..6,9,11       ; 3018
.shutter 1011110010110 1,3..6,9,11..12   ; 3019
.shutter 1011110011000 1,3..6,9..10      ; 3020
.shutter 1011110011010 1,3..6,9..10,12   ; 3021
.shutter 1011110011100 1,3..6,9..11      ; 3022
.shutter 1011110011110 1,3..6,9..12      ; 3023
.shutter 1011110100000 1,3..6,8          ; 3024
.shutter 1011110100010 1,3..6,8,12       ; 3025
.shutter 1011110100100 1,3..6,8,11       ; 3026
.shutter 1011110100110 1,3..6,8,11..12   ; 3027
.shutter 1011110101000 1,3..6,8,10       ; 3028
.shutter 1011110101010 1,3..6,8..12/2    ; 3029
.shutter 1011110101100 1,3..6,8,10..11   ; 3030
.shutter 1011110101110 1,3..6,8,10..12   ; 3031
.shutter 1011110110000 1,3..6,8..9       ; 3032
.shutter 1011110110010 1,3..6,8..9,12    ; 3033
.shutter 1011110110100 1,3..6,8..9,11    ; 3034
.shutter 1011110110110 1,3..6,8..9,11..12 ; 3035
.shutter 1011110111000 1,3..6,8..10      ; 3036
.shutter 1011110111010 1,3..6,8..10,12   ; 3037
.shutter 1011110111100 1,3..6,8..11      ; 3038
.shutter 1011110111110 1,3..6,8..12      ; 3039
.shutter 1011111000000 1,3..7            ; 3040
.shutter 1011111000010 1,3..7,12         ; 3041
.shutter 1011111000100 1,3..7,11         ; 3042
.shutter 1011111000110 1,3..7,11..12     ; 3043
.shutter 1011111001000 1,3..7,10         ; 3044
.shutter 1011111001010 1,3..7,10,12      ; 3045
.shutter 1011111001100 1,3..7,10..11     ; 3046
.shutter 1011111001110 1,3..7,10..12     ; 3047
.shutter 1011111010000 1,3..7,9          ; 3048
.shutter 1011111010010 1,3..7,9,12       ; 3049
.shutter 1011111010100 1,3..7,9,11       ; 3050
.shutter 1011111010110 1,3..7,9,11..12   ; 3051
.shutter 1011111011000 1,3..7,9..10      ; 3052
.shutter 1011111011010 1,3..7,9..10,12   ; 3053
.shutter 1011111011100 1,3..7,9..11      ; 3054
.shutter 1011111011110 1,3..7,9..12      ; 3055
.shutter 1011111100000 1,3..8            ; 3056
.shutter 1011111100010 1,3..8,12         ; 3057
.shutter 1011111100100 1,3..8,11         ; 3058
.shutter 1011111100110 1,3..8,11..12     ; 3059
.shutter 1011111101000 1,3..8,10         ; 3060
.shutter 1011111101010 1,3..8,10,12      ; 3061
.shutter 1011111101100 1,3..8,10..11     ; 3062
.shutter 1011111101110 1,3..8,10..12     ; 3063
.shutter 1011111110000 1,3..9            ; 3064
.shutter 1011111110010 1,3..9,12         ; 3065
.shutter 1011111110100 1,3..9,11         ; 3066
.shutter 1011111110110 1,3..9,11..12     ; 3067
.shutter 1011111111000 1,3..10           ; 3068
.shutter 1011111111010 1,3..10,12        ; 3069
.shutter 1011111111100 1,3..11           ; 3070
.shutter 1011111111110 1,3..12           ; 3071
.shutter 1100000000000 1..2              ; 3072
.shutter 1100000000010 1..2,12           ; 3073
.shutter 1100000000100 1..2,11           ; 3074
.shutter 1100000000110 1..2,11..12       ; 3075
.shutter 1100000001000 1..2,10           ; 3076
.shutter 1100000001010 1..2,10,12        ; 3077
.shutter 1100000001100 1..2,10..11       ; 3078
.shutter 1100000001110 1..2,10..12       ; 3079
.shutter 1100000010000 1..2,9            ; 3080
.shutter 1100000010010 1..2,9,12         ; 3081
.shutter 1100000010100 1..2,9,11         ; 3082
.shutter 1100000010110 1..2,9,11..12     ; 3083
.shutter 1100000011000 1..2,9..10        ; 3084
.shutter 1100000011010 1..2,9..10,12     ; 3085
.shutter 1100000011100 1..2,9..11        ; 3086
.shutter 1100000011110 1..2,9..12        ; 3087
.shutter 1100000100000 1..2,8            ; 3088
.shutter 1100000100010 1..2,8,12         ; 3089
.shutter 1100000100100 1..2,8,11         ; 3090
.shutter 1100000100110 1..2,8,11..12     ; 3091
.shutter 1100000101000 1..2,8,10         ; 3092
.shutter 1100000101010 1..2,8,10,12      ; 3093
.shutter 1100000101100 1..2,8,10..11     ; 3094
.shutter 1100000101110 1..2,8,10..12     ; 3095
.shutter 1100000110000 1..2,8..9         ; 3096
.shutter 1100000110010 1..2,8..9,12      ; 3097
.shutter 1100000110100 1..2,8..9,11      ; 3098
.shutter 1100000110110 1..2,8..9,11..12  ; 3099
.shutter 1100000111000 1..2,8..10        ; 3100
.shutter 1100000111010 1..2,8..10,12     ; 3101
.shutter 1100000111100 1..2,8..11        ; 3102
.shutter 1100000111110 1..2,8..12        ; 3103
.shutter 1100001000000 1..2,7            ; 3104
.shutter 1100001000010 1..2,7,12         ; 3105
.shutter 1100001000100 1..2,7,11         ; 3106
.shutter 1100001000110 1..2,7,11..12     ; 3107
.shutter 1100001001000 1..2,7,10         ; 3108
.shutter 1100001001010 1..2,7,10,12      ; 3109
.shutter 1100001001100 1..2,7,10..11     ; 3110
.shutter 1100001001110 1..2,7,10..12     ; 3111
.shutter 1100001010000 1..2,7,9          ; 3112
.shutter 1100001010010 1..2,7,9,12       ; 3113
.shutter 1100001010100 1..2,7,9,11       ; 3114
.shutter 1100001010110 1..2,7,9,11..12   ; 3115
.shutter 1100001011000 1..2,7,9..10      ; 3116
.shutter 1100001011010 1..2,7,9..10,12   ; 3117
.shutter 1100001011100 1..2,7,9..11      ; 3118
.shutter 1100001011110 1..2,7,9..12      ; 3119
.shutter 1100001100000 1..2,7..8         ; 3120
.shutter 1100001100010 1..2,7..8,12      ; 3121
.shutter 1100001100100 1..2,7..8,11      ; 3122
.shutter 1100001100110 1..2,7..8,11..12  ; 3123
.shutter 1100001101000 1..2,7..8,10      ; 3124
.shutter 1100001101010 1..2,7..8,10,12   ; 3125
.shutter 1100001101100 1..2,7..8,10..11  ; 3126
.shutter 1100001101110 1..2,7..8,10..12  ; 3127
.shutter 1100001110000 1..2,7..9         ; 3128
.shutter 1100001110010 1..2,7..9,12      ; 3129
.shutter 1100001110100 1..2,7..9,11      ; 3130
.shutter 1100001110110 1..2,7..9,11..12  ; 3131
.shutter 1100001111000 1..2,7..10        ; 3132
.shutter 1100001111010 1..2,7..10,12     ; 3133
.shutter 1100001111100 1..2,7..11        ; 3134
.shutter 1100001111110 1..2,7..12        ; 3135
.shutter 1100010000000 1..2,6            ; 3136
.shutter 1100010000010 1..2,6,12         ; 3137
.shutter 1100010000100 1..2,6,11         ; 3138
.shutter 1100010000110 1..2,6,11..12     ; 3139
.shutter 1100010001000 1..2,6,10         ; 3140
.shutter 1100010001010 1..2,6,10,12      ; 3141
.shutter 1100010001100 1..2,6,10..11     ; 3142
.shutter 1100010001110 1..2,6,10..12     ; 3143
.shutter 1100010010000 1..2,6,9          ; 3144
.shutter 1100010010010 1..2,6,9,12       ; 3145
.shutter 1100010010100 1..2,6,9,11       ; 3146
.shutter 1100010010110 1..2,6,9,11..12   ; 3147
.shutter 1100010011000 1..2,6,9..10      ; 3148
.shutter 1100010011010 1..2,6,9..10,12   ; 3149
.shutter 1100010011100 1..2,6,9..11      ; 3150
.shutter 1100010011110 1..2,6,9..12      ; 3151
.shutter 1100010100000 1..2,6,8          ; 3152
.shutter 1100010100010 1..2,6,8,12       ; 3153
.shutter 1100010100100 1..2,6,8,11       ; 3154
.shutter 1100010100110 1..2,6,8,11..12   ; 3155
.shutter 1100010101000 1..2,6,8,10       ; 3156
.shutter 1100010101010 1..2,6..12/2      ; 3157
.shutter 1100010101100 1..2,6,8,10..11   ; 3158
.shutter 1100010101110 1..2,6,8,10..12   ; 3159
.shutter 1100010110000 1..2,6,8..9       ; 3160
.shutter 1100010110010 1..2,6,8..9,12    ; 3161
.shutter 1100010110100 1..2,6,8..9,11    ; 3162
.shutter 1100010110110 1..2,6,8..9,11..12 ; 3163
.shutter 1100010111000 1..2,6,8..10      ; 3164
.shutter 1100010111010 1..2,6,8..10,12   ; 3165
.shutter 1100010111100 1..2,6,8..11      ; 3166
.shutter 1100010111110 1..2,6,8..12      ; 3167
.shutter 1100011000000 1..2,6..7         ; 3168
.shutter 1100011000010 1..2,6..7,12      ; 3169
.shutter 1100011000100 1..2,6..7,11      ; 3170
.shutter 1100011000110 1..2,6..7,11..12  ; 3171
.shutter 1100011001000 1..2,6..7,10      ; 3172
.shutter 1100011001010 1..2,6..7,10,12   ; 3173
.shutter 1100011001100 1..2,6..7,10..11  ; 3174
.shutter 1100011001110 1..2,6..7,10..12  ; 3175
.shutter 1100011010000 1..2,6..7,9       ; 3176
.shutter 1100011010010 1..2,6..7,9,12    ; 3177
.shutter 1100011010100 1..2,6..7,9,11    ; 3178
.shutter 1100011010110 1..2,6..7,9,11..12 ; 3179
.shutter 1100011011000 1..2,6..7,9..10   ; 3180
.shutter 1100011011010 1..2,6..7,9..10,12 ; 3181
.shutter 1100011011100 1..2,6..7,9..11   ; 3182
.shutter 1100011011110 1..2,6..7,9..12   ; 3183
.shutter 1100011100000 1..2,6..8         ; 3184
.shutter 1100011100010 1..2,6..8,12      ; 3185
.shutter 1100011100100 1..2,6..8,11      ; 3186
.shutter 1100011100110 1..2,6..8,11..12  ; 3187
.shutter 1100011101000 1..2,6..8,10      ; 3188
.shutter 1100011101010 1..2,6..8,10,12   ; 3189
.shutter 1100011101100 1..2,6..8,10..11  ; 3190
.shutter 1100011101110 1..2,6..8,10..12  ; 3191
.shutter 1100011110000 1..2,6..9         ; 3192
.shutter 1100011110010 1..2,6..9,12      ; 3193
.shutter 1100011110100 1..2,6..9,11      ; 3194
.shutter 1100011110110 1..2,6..9,11..12  ; 3195
.shutter 1100011111000 1..2,6..10        ; 3196
.shutter 1100011111010 1..2,6..10,12     ; 3197
.shutter 1100011111100 1..2,6..11        ; 3198
.shutter 1100011111110 1..2,6..12        ; 3199
.shutter 1100100000000 1..2,5            ; 3200
.shutter 1100100000010 1..2,5,12         ; 3201
.shutter 1100100000100 1..2,5,11         ; 3202
.shutter 1100100000110 1..2,5,11..12     ; 3203
.shutter 1100100001000 1..2,5,10         ; 3204
.shutter 1100100001010 1..2,5,10,12      ; 3205
.shutter 1100100001100 1..2,5,10..11     ; 3206
.shutter 1100100001110 1..2,5,10..12     ; 3207
.shutter 1100100010000 1..2,5,9          ; 3208
.shutter 1100100010010 1..2,5,9,12       ; 3209
.shutter 1100100010100 1..2,5,9,11       ; 3210
.shutter 1100100010110 1..2,5,9,11..12   ; 3211
.shutter 1100100011000 1..2,5,9..10      ; 3212
.shutter 1100100011010 1..2,5,9..10,12   ; 3213
.shutter 1100100011100 1..2,5,9..11      ; 3214
.shutter 1100100011110 1..2,5,9..12      ; 3215
.shutter 1100100100000 1..2,5,8          ; 3216
.shutter 1100100100010 1..2,5,8,12       ; 3217
.shutter 1100100100100 1..2,5,8,11       ; 3218
.shutter 1100100100110 1..2,5,8,11..12   ; 3219
.shutter 1100100101000 1..2,5,8,10       ; 3220
.shutter 1100100101010 1..2,5,8..12/2    ; 3221
.shutter 1100100101100 1..2,5,8,10..11   ; 3222
.shutter 1100100101110 1..2,5,8,10..12   ; 3223
.shutter 1100100110000 1..2,5,8..9       ; 3224
.shutter 1100100110010 1..2,5,8..9,12    ; 3225
.shutter 1100100110100 1..2,5,8..9,11    ; 3226
.shutter 1100100110110 1..2,5,8..9,11..12 ; 3227
.shutter 1100100111000 1..2,5,8..10      ; 3228
.shutter 1100100111010 1..2,5,8..10,12   ; 3229
.shutter 1100100111100 1..2,5,8..11      ; 3230
.shutter 1100100111110 1..2,5,8..12      ; 3231
.shutter 1100101000000 1..2,5,7          ; 3232
.shutter 1100101000010 1..2,5,7,12       ; 3233
.shutter 1100101000100 1..2,5,7,11       ; 3234
.shutter 1100101000110 1..2,5,7,11..12   ; 3235
.shutter 1100101001000 1..2,5,7,10       ; 3236
.shutter 1100101001010 1..2,5,7,10,12    ; 3237
.shutter 1100101001100 1..2,5,7,10..11   ; 3238
.shutter 1100101001110 1..2,5,7,10..12   ; 3239
.shutter 1100101010000 1..2,5,7,9        ; 3240
.shutter 1100101010010 1..2,5..9/2,12    ; 3241
.shutter 1100101010100 1..2,5..11/2      ; 3242
.shutter 1100101010110 1..2,5..11/2,12   ; 3243
.shutter 1100101011000 1..2,5,7,9..10    ; 3244
.shutter 1100101011010 1..2,5..9/2,10,12 ; 3245
.shutter 1100101011100 1..2,5,7,9..11    ; 3246
.shutter 1100101011110 1..2,5,7,9..12    ; 3247
.shutter 1100101100000 1..2,5,7..8       ; 3248
.shutter 1100101100010 1..2,5,7..8,12    ; 3249
.shutter 1100101100100 1..2,5,7..8,11    ; 3250
.shutter 1100101100110 1..2,5,7..8,11..12 ; 3251
.shutter 1100101101000 1..2,5,7..8,10    ; 3252
.shutter 1100101101010 1..2,5,7..8,10,12 ; 3253
.shutter 1100101101100 1..2,5,7..8,10..11 ; 3254
.shutter 1100101101110 1..2,5,7..8,10..12 ; 3255
.shutter 1100101110000 1..2,5,7..9       ; 3256
.shutter 1100101110010 1..2,5,7..9,12    ; 3257
.shutter 1100101110100 1..2,5,7..9,11    ; 3258
.shutter 1100101110110 1..2,5,7..9,11..12 ; 3259
.shutter 1100101111000 1..2,5,7..10      ; 3260
.shutter 1100101111010 1..2,5,7..10,12   ; 3261
.shutter 1100101111100 1..2,5,7..11      ; 3262
.shutter 1100101111110 1..2,5,7..12      ; 3263
.shutter 1100110000000 1..2,5..6         ; 3264
.shutter 1100110000010 1..2,5..6,12      ; 3265
.shutter 1100110000100 1..2,5..6,11      ; 3266
.shutter 1100110000110 1..2,5..6,11..12  ; 3267
.shutter 1100110001000 1..2,5..6,10      ; 3268
.shutter 1100110001010 1..2,5..6,10,12   ; 3269
.shutter 1100110001100 1..2,5..6,10..11  ; 3270
.shutter 1100110001110 1..2,5..6,10..12  ; 3271
.shutter 1100110010000 1..2,5..6,9       ; 3272
.shutter 1100110010010 1..2,5..6,9,12    ; 3273
.shutter 1100110010100 1..2,5..6,9,11    ; 3274
.shutter 1100110010110 1..2,5..6,9,11..12 ; 3275
.shutter 1100110011000 1..2,5..6,9..10   ; 3276
.shutter 1100110011010 1..2,5..6,9..10,12 ; 3277
.shutter 1100110011100 1..2,5..6,9..11   ; 3278
.shutter 1100110011110 1..2,5..6,9..12   ; 3279
.shutter 1100110100000 1..2,5..6,8       ; 3280
.shutter 1100110100010 1..2,5..6,8,12    ; 3281
.shutter 1100110100100 1..2,5..6,8,11    ; 3282
.shutter 1100110100110 1..2,5..6,8,11..12 ; 3283
.shutter 1100110101000 1..2,5..6,8,10    ; 3284
.shutter 1100110101010 1..2,5..6,8..12/2 ; 3285
.shutter 1100110101100 1..2,5..6,8,10..11 ; 3286
.shutter 1100110101110 1..2,5..6,8,10..12 ; 3287
.shutter 1100110110000 1..2,5..6,8..9    ; 3288
.shutter 1100110110010 1..2,5..6,8..9,12 ; 3289
.shutter 1100110110100 1..2,5..6,8..9,11 ; 3290
.shutter 1100110110110 1..2,5..6,8..9,11..12 ; 3291
.shutter 1100110111000 1..2,5..6,8..10   ; 3292
.shutter 1100110111010 1..2,5..6,8..10,12 ; 3293
.shutter 1100110111100 1..2,5..6,8..11   ; 3294
.shutter 1100110111110 1..2,5..6,8..12   ; 3295
.shutter 1100111000000 1..2,5..7         ; 3296
.shutter 1100111000010 1..2,5..7,12      ; 3297
.shutter 1100111000100 1..2,5..7,11      ; 3298
.shutter 1100111000110 1..2,5..7,11..12  ; 3299
.shutter 1100111001000 1..2,5..7,10      ; 3300
.shutter 1100111001010 1..2,5..7,10,12   ; 3301
.shutter 1100111001100 1..2,5..7,10..11  ; 3302
.shutter 1100111001110 1..2,5..7,10..12  ; 3303
.shutter 1100111010000 1..2,5..7,9       ; 3304
.shutter 1100111010010 1..2,5..7,9,12    ; 3305
.shutter 1100111010100 1..2,5..7,9,11    ; 3306
.shutter 1100111010110 1..2,5..7,9,11..12 ; 3307
.shutter 1100111011000 1..2,5..7,9..10   ; 3308
.shutter 1100111011010 1..2,5..7,9..10,12 ; 3309
.shutter 1100111011100 1..2,5..7,9..11   ; 3310
.shutter 1100111011110 1..2,5..7,9..12   ; 3311
.shutter 1100111100000 1..2,5..8         ; 3312
.shutter 1100111100010 1..2,5..8,12      ; 3313
.shutter 1100111100100 1..2,5..8,11      ; 3314
.shutter 1100111100110 1..2,5..8,11..12  ; 3315
.shutter 1100111101000 1..2,5..8,10      ; 3316
.shutter 1100111101010 1..2,5..8,10,12   ; 3317
.shutter 1100111101100 1..2,5..8,10..11  ; 3318
.shutter 1100111101110 1..2,5..8,10..12  ; 3319
.shutter 1100111110000 1..2,5..9         ; 3320
.shutter 1100111110010 1..2,5..9,12      ; 3321
.shutter 1100111110100 1..2,5..9,11      ; 3322
.shutter 1100111110110 1..2,5..9,11..12  ; 3323
.shutter 1100111111000 1..2,5..10        ; 3324
.shutter 1100111111010 1..2,5..10,12     ; 3325
.shutter 1100111111100 1..2,5..11        ; 3326
.shutter 1100111111110 1..2,5..12        ; 3327
.shutter 1101000000000 1..2,4            ; 3328
.shutter 1101000000010 1..2,4,12         ; 3329
.shutter 1101000000100 1..2,4,11         ; 3330
.shutter 1101000000110 1..2,4,11..12     ; 3331
.shutter 1101000001000 1..2,4,10         ; 3332
.shutter 1101000001010 1..2,4,10,12      ; 3333
.shutter 1101000001100 1..2,4,10..11     ; 3334
.shutter 1101000001110 1..2,4,10..12     ; 3335
.shutter 1101000010000 1..2,4,9          ; 3336
.shutter 1101000010010 1..2,4,9,12       ; 3337
.shutter 1101000010100 1..2,4,9,11       ; 3338
.shutter 1101000010110 1..2,4,9,11..12   ; 3339
.shutter 1101000011000 1..2,4,9..10      ; 3340
.shutter 1101000011010 1..2,4,9..10,12   ; 3341
.shutter 1101000011100 1..2,4,9..11      ; 3342
.shutter 1101000011110 1..2,4,9..12      ; 3343
.shutter 1101000100000 1..2,4,8          ; 3344
.shutter 1101000100010 1..2,4,8,12       ; 3345
.shutter 1101000100100 1..2,4,8,11       ; 3346
.shutter 1101000100110 1..2,4,8,11..12   ; 3347
.shutter 1101000101000 1..2,4,8,10       ; 3348
.shutter 1101000101010 1..2,4,8..12/2    ; 3349
.shutter 1101000101100 1..2,4,8,10..11   ; 3350
.shutter 1101000101110 1..2,4,8,10..12   ; 3351
.shutter 1101000110000 1..2,4,8..9       ; 3352
.shutter 1101000110010 1..2,4,8..9,12    ; 3353
.shutter 1101000110100 1..2,4,8..9,11    ; 3354
.shutter 1101000110110 1..2,4,8..9,11..12 ; 3355
.shutter 1101000111000 1..2,4,8..10      ; 3356
.shutter 1101000111010 1..2,4,8..10,12   ; 3357
.shutter 1101000111100 1..2,4,8..11      ; 3358
.shutter 1101000111110 1..2,4,8..12      ; 3359
.shutter 1101001000000 1..2,4,7          ; 3360
.shutter 1101001000010 1..2,4,7,12       ; 3361
.shutter 1101001000100 1..2,4,7,11       ; 3362
.shutter 1101001000110 1..2,4,7,11..12   ; 3363
.shutter 1101001001000 1..2,4,7,10       ; 3364
.shutter 1101001001010 1..2,4..10/3,12   ; 3365
.shutter 1101001001100 1..2,4,7,10..11   ; 3366
.shutter 1101001001110 1..2,4,7,10..12   ; 3367
.shutter 1101001010000 1..2,4,7,9        ; 3368
.shutter 1101001010010 1..2,4,7,9,12     ; 3369
.shutter 1101001010100 1..2,4,7..11/2    ; 3370
.shutter 1101001010110 1..2,4,7..11/2,12 ; 3371
.shutter 1101001011000 1..2,4,7,9..10    ; 3372
.shutter 1101001011010 1..2,4,7,9..10,12 ; 3373
.shutter 1101001011100 1..2,4,7,9..11    ; 3374
.shutter 1101001011110 1..2,4,7,9..12    ; 3375
.shutter 1101001100000 1..2,4,7..8       ; 3376
.shutter 1101001100010 1..2,4,7..8,12    ; 3377
.shutter 1101001100100 1..2,4,7..8,11    ; 3378
.shutter 1101001100110 1..2,4,7..8,11..12 ; 3379
.shutter 1101001101000 1..2,4,7..8,10    ; 3380
.shutter 1101001101010 1..2,4,7..8,10,12 ; 3381
.shutter 1101001101100 1..2,4,7..8,10..11 ; 3382
.shutter 1101001101110 1..2,4,7..8,10..12 ; 3383
.shutter 1101001110000 1..2,4,7..9       ; 3384
.shutter 1101001110010 1..2,4,7..9,12    ; 3385
.shutter 1101001110100 1..2,4,7..9,11    ; 3386
.shutter 1101001110110 1..2,4,7..9,11..12 ; 3387
.shutter 1101001111000 1..2,4,7..10      ; 3388
.shutter 1101001111010 1..2,4,7..10,12   ; 3389
.shutter 1101001111100 1..2,4,7..11      ; 3390
.shutter 1101001111110 1..2,4,7..12      ; 3391
.shutter 1101010000000 1..2,4,6          ; 3392
.shutter 1101010000010 1..2,4,6,12       ; 3393
.shutter 1101010000100 1..2,4,6,11       ; 3394
.shutter 1101010000110 1..2,4,6,11..12   ; 3395
.shutter 1101010001000 1..2,4,6,10       ; 3396
.shutter 1101010001010 1..2,4,6,10,12    ; 3397
.shutter 1101010001100 1..2,4,6,10..11   ; 3398
.shutter 1101010001110 1..2,4,6,10..12   ; 3399
.shutter 1101010010000 1..2,4,6,9        ; 3400
.shutter 1101010010010 1..2,4,6..12/3    ; 3401
.shutter 1101010010100 1..2,4,6,9,11     ; 3402
.shutter 1101010010110 1..2,4,6,9,11..12 ; 3403
.shutter 1101010011000 1..2,4,6,9..10    ; 3404
.shutter 1101010011010 1..2,4,6,9..10,12 ; 3405
.shutter 1101010011100 1..2,4,6,9..11    ; 3406
.shutter 1101010011110 1..2,4,6,9..12    ; 3407
.shutter 1101010100000 1..2,4,6,8        ; 3408
.shutter 1101010100010 1..2,4..8/2,12    ; 3409
.shutter 1101010100100 1..2,4..8/2,11    ; 3410
.shutter 1101010100110 1..2,4..8/2,11..12 ; 3411
.shutter 1101010101000 1..2,4..10/2      ; 3412
.shutter 1101010101010 1..2,4..12/2      ; 3413
.shutter 1101010101100 1..2,4..10/2,11   ; 3414
.shutter 1101010101110 1..2,4..10/2,11..12 ; 3415
.shutter 1101010110000 1..2,4,6,8..9     ; 3416
.shutter 1101010110010 1..2,4..8/2,9,12  ; 3417
.shutter 1101010110100 1..2,4..8/2,9,11  ; 3418
.shutter 1101010110110 1..2,4..8/2,9,11..12 ; 3419
.shutter 1101010111000 1..2,4,6,8..10    ; 3420
.shutter 1101010111010 1..2,4..8/2,9..10,12 ; 3421
.shutter 1101010111100 1..2,4,6,8..11    ; 3422
.shutter 1101010111110 1..2,4,6,8..12    ; 3423
.shutter 1101011000000 1..2,4,6..7       ; 3424
.shutter 1101011000010 1..2,4,6..7,12    ; 3425
.shutter 1101011000100 1..2,4,6..7,11    ; 3426
.shutter 1101011000110 1..2,4,6..7,11..12 ; 3427
.shutter 1101011001000 1..2,4,6..7,10    ; 3428
.shutter 1101011001010 1..2,4,6..7,10,12 ; 3429
.shutter 1101011001100 1..2,4,6..7,10..11 ; 3430
.shutter 1101011001110 1..2,4,6..7,10..12 ; 3431
.shutter 1101011010000 1..2,4,6..7,9     ; 3432
.shutter 1101011010010 1..2,4,6..7,9,12  ; 3433
.shutter 1101011010100 1..2,4,6..7,9,11  ; 3434
.shutter 1101011010110 1..2,4,6..7,9,11..12 ; 3435
.shutter 1101011011000 1..2,4,6..7,9..10 ; 3436
.shutter 1101011011010 1..2,4,6..7,9..10,12 ; 3437
.shutter 1101011011100 1..2,4,6..7,9..11 ; 3438
.shutter 1101011011110 1..2,4,6..7,9..12 ; 3439
.shutter 1101011100000 1..2,4,6..8       ; 3440
.shutter 1101011100010 1..2,4,6..8,12    ; 3441
.shutter 1101011100100 1..2,4,6..8,11    ; 3442
.shutter 1101011100110 1..2,4,6..8,11..12 ; 3443
.shutter 1101011101000 1..2,4,6..8,10    ; 3444
.shutter 1101011101010 1..2,4,6..8,10,12 ; 3445
.shutter 1101011101100 1..2,4,6..8,10..11 ; 3446
.shutter 1101011101110 1..2,4,6..8,10..12 ; 3447
.shutter 1101011110000 1..2,4,6..9       ; 3448
.shutter 1101011110010 1..2,4,6..9,12    ; 3449
.shutter 1101011110100 1..2,4,6..9,11    ; 3450
.shutter 1101011110110 1..2,4,6..9,11..12 ; 3451
.shutter 1101011111000 1..2,4,6..10      ; 3452
.shutter 1101011111010 1..2,4,6..10,12   ; 3453
.shutter 1101011111100 1..2,4,6..11      ; 3454
.shutter 1101011111110 1..2,4,6..12      ; 3455
.shutter 1101100000000 1..2,4..5         ; 3456
.shutter 1101100000010 1..2,4..5,12      ; 3457
.shutter 1101100000100 1..2,4..5,11      ; 3458
.shutter 1101100000110 1..2,4..5,11..12  ; 3459
.shutter 1101100001000 1..2,4..5,10      ; 3460
.shutter 1101100001010 1..2,4..5,10,12   ; 3461
.shutter 1101100001100 1..2,4..5,10..11  ; 3462
.shutter 1101100001110 1..2,4..5,10..12  ; 3463
.shutter 1101100010000 1..2,4..5,9       ; 3464
.shutter 1101100010010 1..2,4..5,9,12    ; 3465
.shutter 1101100010100 1..2,4..5,9,11    ; 3466
.shutter 1101100010110 1..2,4..5,9,11..12 ; 3467
.shutter 1101100011000 1..2,4..5,9..10   ; 3468
.shutter 1101100011010 1..2,4..5,9..10,12 ; 3469
.shutter 1101100011100 1..2,4..5,9..11   ; 3470
.shutter 1101100011110 1..2,4..5,9..12   ; 3471
.shutter 1101100100000 1..2,4..5,8       ; 3472
.shutter 1101100100010 1..2,4..5,8,12    ; 3473
.shutter 1101100100100 1..2,4..5,8,11    ; 3474
.shutter 1101100100110 1..2,4..5,8,11..12 ; 3475
.shutter 1101100101000 1..2,4..5,8,10    ; 3476
.shutter 1101100101010 1..2,4..5,8..12/2 ; 3477
.shutter 1101100101100 1..2,4..5,8,10..11 ; 3478
.shutter 1101100101110 1..2,4..5,8,10..12 ; 3479
.shutter 1101100110000 1..2,4..5,8..9    ; 3480
.shutter 1101100110010 1..2,4..5,8..9,12 ; 3481
.shutter 1101100110100 1..2,4..5,8..9,11 ; 3482
.shutter 1101100110110 1..2,4..5,8..9,11..12 ; 3483
.shutter 1101100111000 1..2,4..5,8..10   ; 3484
.shutter 1101100111010 1..2,4..5,8..10,12 ; 3485
.shutter 1101100111100 1..2,4..5,8..11   ; 3486
.shutter 1101100111110 1..2,4..5,8..12   ; 3487
.shutter 1101101000000 1..2,4..5,7       ; 3488
.shutter 1101101000010 1..2,4..5,7,12    ; 3489
.shutter 1101101000100 1..2,4..5,7,11    ; 3490
.shutter 1101101000110 1..2,4..5,7,11..12 ; 3491
.shutter 1101101001000 1..2,4..5,7,10    ; 3492
.shutter 1101101001010 1..2,4..5,7,10,12 ; 3493
.shutter 1101101001100 1..2,4..5,7,10..11 ; 3494
.shutter 1101101001110 1..2,4..5,7,10..12 ; 3495
.shutter 1101101010000 1..2,4..5,7,9     ; 3496
.shutter 1101101010010 1..2,4..5,7,9,12  ; 3497
.shutter 1101101010100 1..2,4..5,7..11/2 ; 3498
.shutter 1101101010110 1..2,4..5,7..11/2,12 ; 3499
.shutter 1101101011000 1..2,4..5,7,9..10 ; 3500
.shutter 1101101011010 1..2,4..5,7,9..10,12 ; 3501
.shutter 1101101011100 1..2,4..5,7,9..11 ; 3502
.shutter 1101101011110 1..2,4..5,7,9..12 ; 3503
.shutter 1101101100000 1..2,4..5,7..8    ; 3504
.shutter 1101101100010 1..2,4..5,7..8,12 ; 3505
.shutter 1101101100100 1..2,4..5,7..8,11 ; 3506
.shutter 1101101100110 1..2,4..5,7..8,11..12 ; 3507
.shutter 1101101101000 1..2,4..5,7..8,10 ; 3508
.shutter 1101101101010 1..2,4..5,7..8,10,12 ; 3509
.shutter 1101101101100 1..2,4..5,7..8,10..11 ; 3510
.shutter 1101101101110 1..2,4..5,7..8,10..12 ; 3511
.shutter 1101101110000 1..2,4..5,7..9    ; 3512
.shutter 1101101110010 1..2,4..5,7..9,12 ; 3513
.shutter 1101101110100 1..2,4..5,7..9,11 ; 3514
.shutter 1101101110110 1..2,4..5,7..9,11..12 ; 3515
.shutter 1101101111000 1..2,4..5,7..10   ; 3516
.shutter 1101101111010 1..2,4..5,7..10,12 ; 3517
.shutter 1101101111100 1..2,4..5,7..11   ; 3518
.shutter 1101101111110 1..2,4..5,7..12   ; 3519
.shutter 1101110000000 1..2,4..6         ; 3520
.shutter 1101110000010 1..2,4..6,12      ; 3521
.shutter 1101110000100 1..2,4..6,11      ; 3522
.shutter 1101110000110 1..2,4..6,11..12  ; 3523
.shutter 1101110001000 1..2,4..6,10      ; 3524
.shutter 1101110001010 1..2,4..6,10,12   ; 3525
.shutter 1101110001100 1..2,4..6,10..11  ; 3526
.shutter 1101110001110 1..2,4..6,10..12  ; 3527
.shutter 1101110010000 1..2,4..6,9       ; 3528
.shutter 1101110010010 1..2,4..6,9,12    ; 3529
.shutter 1101110010100 1..2,4..6,9,11    ; 3530
.shutter 1101110010110 1..2,4..6,9,11..12 ; 3531
.shutter 1101110011000 1..2,4..6,9..10   ; 3532
.shutter 1101110011010 1..2,4..6,9..10,12 ; 3533
.shutter 1101110011100 1..2,4..6,9..11   ; 3534
.shutter 1101110011110 1..2,4..6,9..12   ; 3535
.shutter 1101110100000 1..2,4..6,8       ; 3536
.shutter 1101110100010 1..2,4..6,8,12    ; 3537
.shutter 1101110100100 1..2,4..6,8,11    ; 3538
.shutter 1101110100110 1..2,4..6,8,11..12 ; 3539
.shutter 1101110101000 1..2,4..6,8,10    ; 3540
.shutter 1101110101010 1..2,4..6,8..12/2 ; 3541
.shutter 1101110101100 1..2,4..6,8,10..11 ; 3542
.shutter 1101110101110 1..2,4..6,8,10..12 ; 3543
.shutter 1101110110000 1..2,4..6,8..9    ; 3544
.shutter 1101110110010 1..2,4..6,8..9,12 ; 3545
.shutter 1101110110100 1..2,4..6,8..9,11 ; 3546
.shutter 1101110110110 1..2,4..6,8..9,11..12 ; 3547
.shutter 1101110111000 1..2,4..6,8..10   ; 3548
.shutter 1101110111010 1..2,4..6,8..10,12 ; 3549
.shutter 1101110111100 1..2,4..6,8..11   ; 3550
.shutter 1101110111110 1..2,4..6,8..12   ; 3551
.shutter 1101111000000 1..2,4..7         ; 3552
.shutter 1101111000010 1..2,4..7,12      ; 3553
.shutter 1101111000100 1..2,4..7,11      ; 3554
.shutter 1101111000110 1..2,4..7,11..12  ; 3555
.shutter 1101111001000 1..2,4..7,10      ; 3556
.shutter 1101111001010 1..2,4..7,10,12   ; 3557
.shutter 1101111001100 1..2,4..7,10..11  ; 3558
.shutter 1101111001110 1..2,4..7,10..12  ; 3559
.shutter 1101111010000 1..2,4..7,9       ; 3560
.shutter 1101111010010 1..2,4..7,9,12    ; 3561
.shutter 1101111010100 1..2,4..7,9,11    ; 3562
.shutter 1101111010110 1..2,4..7,9,11..12 ; 3563
.shutter 1101111011000 1..2,4..7,9..10   ; 3564
.shutter 1101111011010 1..2,4..7,9..10,12 ; 3565
.shutter 1101111011100 1..2,4..7,9..11   ; 3566
.shutter 1101111011110 1..2,4..7,9..12   ; 3567
.shutter 1101111100000 1..2,4..8         ; 3568
.shutter 1101111100010 1..2,4..8,12      ; 3569
.shutter 1101111100100 1..2,4..8,11      ; 3570
.shutter 1101111100110 1..2,4..8,11..12  ; 3571
.shutter 1101111101000 1..2,4..8,10      ; 3572
.shutter 1101111101010 1..2,4..8,10,12   ; 3573
.shutter 1101111101100 1..2,4..8,10..11  ; 3574
.shutter 1101111101110 1..2,4..8,10..12  ; 3575
.shutter 1101111110000 1..2,4..9         ; 3576
.shutter 1101111110010 1..2,4..9,12      ; 3577
.shutter 1101111110100 1..2,4..9,11      ; 3578
.shutter 1101111110110 1..2,4..9,11..12  ; 3579
.shutter 1101111111000 1..2,4..10        ; 3580
.shutter 1101111111010 1..2,4..10,12     ; 3581
.shutter 1101111111100 1..2,4..11        ; 3582
.shutter 1101111111110 1..2,4..12        ; 3583
.shutter 1110000000000 1..3              ; 3584
.shutter 1110000000010 1..3,12           ; 3585
.shutter 1110000000100 1..3,11           ; 3586
.shutter 1110000000110 1..3,11..12       ; 3587
.shutter 1110000001000 1..3,10           ; 3588
.shutter 1110000001010 1..3,10,12        ; 3589
.shutter 1110000001100 1..3,10..11       ; 3590
.shutter 1110000001110 1..3,10..12       ; 3591
.shutter 1110000010000 1..3,9            ; 3592
.shutter 1110000010010 1..3,9,12         ; 3593
.shutter 1110000010100 1..3,9,11         ; 3594
.shutter 1110000010110 1..3,9,11..12     ; 3595
.shutter 1110000011000 1..3,9..10        ; 3596
.shutter 1110000011010 1..3,9..10,12     ; 3597
.shutter 1110000011100 1..3,9..11        ; 3598
.shutter 1110000011110 1..3,9..12        ; 3599
.shutter 1110000100000 1..3,8            ; 3600
.shutter 1110000100010 1..3,8,12         ; 3601
.shutter 1110000100100 1..3,8,11         ; 3602
.shutter 1110000100110 1..3,8,11..12     ; 3603
.shutter 1110000101000 1..3,8,10         ; 3604
.shutter 1110000101010 1..3,8,10,12      ; 3605
.shutter 1110000101100 1..3,8,10..11     ; 3606
.shutter 1110000101110 1..3,8,10..12     ; 3607
.shutter 1110000110000 1..3,8..9         ; 3608
.shutter 1110000110010 1..3,8..9,12      ; 3609
.shutter 1110000110100 1..3,8..9,11      ; 3610
.shutter 1110000110110 1..3,8..9,11..12  ; 3611
.shutter 1110000111000 1..3,8..10        ; 3612
.shutter 1110000111010 1..3,8..10,12     ; 3613
.shutter 1110000111100 1..3,8..11        ; 3614
.shutter 1110000111110 1..3,8..12        ; 3615
.shutter 1110001000000 1..3,7            ; 3616
.shutter 1110001000010 1..3,7,12         ; 3617
.shutter 1110001000100 1..3,7,11         ; 3618
.shutter 1110001000110 1..3,7,11..12     ; 3619
.shutter 1110001001000 1..3,7,10         ; 3620
.shutter 1110001001010 1..3,7,10,12      ; 3621
.shutter 1110001001100 1..3,7,10..11     ; 3622
.shutter 1110001001110 1..3,7,10..12     ; 3623
.shutter 1110001010000 1..3,7,9          ; 3624
.shutter 1110001010010 1..3,7,9,12       ; 3625
.shutter 1110001010100 1..3,7,9,11       ; 3626
.shutter 1110001010110 1..3,7,9,11..12   ; 3627
.shutter 1110001011000 1..3,7,9..10      ; 3628
.shutter 1110001011010 1..3,7,9..10,12   ; 3629
.shutter 1110001011100 1..3,7,9..11      ; 3630
.shutter 1110001011110 1..3,7,9..12      ; 3631
.shutter 1110001100000 1..3,7..8         ; 3632
.shutter 1110001100010 1..3,7..8,12      ; 3633
.shutter 1110001100100 1..3,7..8,11      ; 3634
.shutter 1110001100110 1..3,7..8,11..12  ; 3635
.shutter 1110001101000 1..3,7..8,10      ; 3636
.shutter 1110001101010 1..3,7..8,10,12   ; 3637
.shutter 1110001101100 1..3,7..8,10..11  ; 3638
.shutter 1110001101110 1..3,7..8,10..12  ; 3639
.shutter 1110001110000 1..3,7..9         ; 3640
.shutter 1110001110010 1..3,7..9,12      ; 3641
.shutter 1110001110100 1..3,7..9,11      ; 3642
.shutter 1110001110110 1..3,7..9,11..12  ; 3643
.shutter 1110001111000 1..3,7..10        ; 3644
.shutter 1110001111010 1..3,7..10,12     ; 3645
.shutter 1110001111100 1..3,7..11        ; 3646
.shutter 1110001111110 1..3,7..12        ; 3647
.shutter 1110010000000 1..3,6            ; 3648
.shutter 1110010000010 1..3,6,12         ; 3649
.shutter 1110010000100 1..3,6,11         ; 3650
.shutter 1110010000110 1..3,6,11..12     ; 3651
.shutter 1110010001000 1..3,6,10         ; 3652
.shutter 1110010001010 1..3,6,10,12      ; 3653
.shutter 1110010001100 1..3,6,10..11     ; 3654
.shutter 1110010001110 1..3,6,10..12     ; 3655
.shutter 1110010010000 1..3,6,9          ; 3656
.shutter 1110010010010 1..3,6,9,12       ; 3657
.shutter 1110010010100 1..3,6,9,11       ; 3658
.shutter 1110010010110 1..3,6,9,11..12   ; 3659
.shutter 1110010011000 1..3,6,9..10      ; 3660
.shutter 1110010011010 1..3,6,9..10,12   ; 3661
.shutter 1110010011100 1..3,6,9..11      ; 3662
.shutter 1110010011110 1..3,6,9..12      ; 3663
.shutter 1110010100000 1..3,6,8          ; 3664
.shutter 1110010100010 1..3,6,8,12       ; 3665
.shutter 1110010100100 1..3,6,8,11       ; 3666
.shutter 1110010100110 1..3,6,8,11..12   ; 3667
.shutter 1110010101000 1..3,6,8,10       ; 3668
.shutter 1110010101010 1..3,6..12/2      ; 3669
.shutter 1110010101100 1..3,6,8,10..11   ; 3670
.shutter 1110010101110 1..3,6,8,10..12   ; 3671
.shutter 1110010110000 1..3,6,8..9       ; 3672
.shutter 1110010110010 1..3,6,8..9,12    ; 3673
.shutter 1110010110100 1..3,6,8..9,11    ; 3674
.shutter 1110010110110 1..3,6,8..9,11..12 ; 3675
.shutter 1110010111000 1..3,6,8..10      ; 3676
.shutter 1110010111010 1..3,6,8..10,12   ; 3677
.shutter 1110010111100 1..3,6,8..11      ; 3678
.shutter 1110010111110 1..3,6,8..12      ; 3679
.shutter 1110011000000 1..3,6..7         ; 3680
.shutter 1110011000010 1..3,6..7,12      ; 3681
.shutter 1110011000100 1..3,6..7,11      ; 3682
.shutter 1110011000110 1..3,6..7,11..12  ; 3683
.shutter 1110011001000 1..3,6..7,10      ; 3684
.shutter 1110011001010 1..3,6..7,10,12   ; 3685
.shutter 1110011001100 1..3,6..7,10..11  ; 3686
.shutter 1110011001110 1..3,6..7,10..12  ; 3687
.shutter 1110011010000 1..3,6..7,9       ; 3688
.shutter 1110011010010 1..3,6..7,9,12    ; 3689
.shutter 1110011010100 1..3,6..7,9,11    ; 3690
.shutter 1110011010110 1..3,6..7,9,11..12 ; 3691
.shutter 1110011011000 1..3,6..7,9..10   ; 3692
.shutter 1110011011010 1..3,6..7,9..10,12 ; 3693
.shutter 1110011011100 1..3,6..7,9..11   ; 3694
.shutter 1110011011110 1..3,6..7,9..12   ; 3695
.shutter 1110011100000 1..3,6..8         ; 3696
.shutter 1110011100010 1..3,6..8,12      ; 3697
.shutter 1110011100100 1..3,6..8,11      ; 3698
.shutter 1110011100110 1..3,6..8,11..12  ; 3699
.shutter 1110011101000 1..3,6..8,10      ; 3700
.shutter 1110011101010 1..3,6..8,10,12   ; 3701
.shutter 1110011101100 1..3,6..8,10..11  ; 3702
.shutter 1110011101110 1..3,6..8,10..12  ; 3703
.shutter 1110011110000 1..3,6..9         ; 3704
.shutter 1110011110010 1..3,6..9,12      ; 3705
.shutter 1110011110100 1..3,6..9,11      ; 3706
.shutter 1110011110110 1..3,6..9,11..12  ; 3707
.shutter 1110011111000 1..3,6..10        ; 3708
.shutter 1110011111010 1..3,6..10,12     ; 3709
.shutter 1110011111100 1..3,6..11        ; 3710
.shutter 1110011111110 1..3,6..12        ; 3711
.shutter 1110100000000 1..3,5            ; 3712
.shutter 1110100000010 1..3,5,12         ; 3713
.shutter 1110100000100 1..3,5,11         ; 3714
.shutter 1110100000110 1..3,5,11..12     ; 3715
.shutter 1110100001000 1..3,5,10         ; 3716
.shutter 1110100001010 1..3,5,10,12      ; 3717
.shutter 1110100001100 1..3,5,10..11     ; 3718
.shutter 1110100001110 1..3,5,10..12     ; 3719
.shutter 1110100010000 1..3,5,9          ; 3720
.shutter 1110100010010 1..3,5,9,12       ; 3721
.shutter 1110100010100 1..3,5,9,11       ; 3722
.shutter 1110100010110 1..3,5,9,11..12   ; 3723
.shutter 1110100011000 1..3,5,9..10      ; 3724
.shutter 1110100011010 1..3,5,9..10,12   ; 3725
.shutter 1110100011100 1..3,5,9..11      ; 3726
.shutter 1110100011110 1..3,5,9..12      ; 3727
.shutter 1110100100000 1..3,5,8          ; 3728
.shutter 1110100100010 1..3,5,8,12       ; 3729
.shutter 1110100100100 1..3,5,8,11       ; 3730
.shutter 1110100100110 1..3,5,8,11..12   ; 3731
.shutter 1110100101000 1..3,5,8,10       ; 3732
.shutter 1110100101010 1..3,5,8..12/2    ; 3733
.shutter 1110100101100 1..3,5,8,10..11   ; 3734
.shutter 1110100101110 1..3,5,8,10..12   ; 3735
.shutter 1110100110000 1..3,5,8..9       ; 3736
.shutter 1110100110010 1..3,5,8..9,12    ; 3737
.shutter 1110100110100 1..3,5,8..9,11    ; 3738
.shutter 1110100110110 1..3,5,8..9,11..12 ; 3739
.shutter 1110100111000 1..3,5,8..10      ; 3740
.shutter 1110100111010 1..3,5,8..10,12   ; 3741
.shutter 1110100111100 1..3,5,8..11      ; 3742
.shutter 1110100111110 1..3,5,8..12      ; 3743
.shutter 1110101000000 1..3,5,7          ; 3744
.shutter 1110101000010 1..3,5,7,12       ; 3745
.shutter 1110101000100 1..3,5,7,11       ; 3746
.shutter 1110101000110 1..3,5,7,11..12   ; 3747
.shutter 1110101001000 1..3,5,7,10       ; 3748
.shutter 1110101001010 1..3,5,7,10,12    ; 3749
.shutter 1110101001100 1..3,5,7,10..11   ; 3750
.shutter 1110101001110 1..3,5,7,10..12   ; 3751
.shutter 1110101010000 1..3,5,7,9        ; 3752
.shutter 1110101010010 1..3,5..9/2,12    ; 3753
.shutter 1110101010100 1..3,5..11/2      ; 3754
.shutter 1110101010110 1..3,5..11/2,12   ; 3755
.shutter 1110101011000 1..3,5,7,9..10    ; 3756
.shutter 1110101011010 1..3,5..9/2,10,12 ; 3757
.shutter 1110101011100 1..3,5,7,9..11    ; 3758
.shutter 1110101011110 1..3,5,7,9..12    ; 3759
.shutter 1110101100000 1..3,5,7..8       ; 3760
.shutter 1110101100010 1..3,5,7..8,12    ; 3761
.shutter 1110101100100 1..3,5,7..8,11    ; 3762
.shutter 1110101100110 1..3,5,7..8,11..12 ; 3763
.shutter 1110101101000 1..3,5,7..8,10    ; 3764
.shutter 1110101101010 1..3,5,7..8,10,12 ; 3765
.shutter 1110101101100 1..3,5,7..8,10..11 ; 3766
.shutter 1110101101110 1..3,5,7..8,10..12 ; 3767
.shutter 1110101110000 1..3,5,7..9       ; 3768
.shutter 1110101110010 1..3,5,7..9,12    ; 3769
.shutter 1110101110100 1..3,5,7..9,11    ; 3770
.shutter 1110101110110 1..3,5,7..9,11..12 ; 3771
.shutter 1110101111000 1..3,5,7..10      ; 3772
.shutter 1110101111010 1..3,5,7..10,12   ; 3773
.shutter 1110101111100 1..3,5,7..11      ; 3774
.shutter 1110101111110 1..3,5,7..12      ; 3775
.shutter 1110110000000 1..3,5..6         ; 3776
.shutter 1110110000010 1..3,5..6,12      ; 3777
.shutter 1110110000100 1..3,5..6,11      ; 3778
.shutter 1110110000110 1..3,5..6,11..12  ; 3779
.shutter 1110110001000 1..3,5..6,10      ; 3780
.shutter 1110110001010 1..3,5..6,10,12   ; 3781
.shutter 1110110001100 1..3,5..6,10..11  ; 3782
.shutter 1110110001110 1..3,5..6,10..12  ; 3783
.shutter 1110110010000 1..3,5..6,9       ; 3784
.shutter 1110110010010 1..3,5..6,9,12    ; 3785
.shutter 1110110010100 1..3,5..6,9,11    ; 3786
.shutter 1110110010110 1..3,5..6,9,11..12 ; 3787
.shutter 1110110011000 1..3,5..6,9..10   ; 3788
.shutter 1110110011010 1..3,5..6,9..10,12 ; 3789
.shutter 1110110011100 1..3,5..6,9..11   ; 3790
.shutter 1110110011110 1..3,5..6,9..12   ; 3791
.shutter 1110110100000 1..3,5..6,8       ; 3792
.shutter 1110110100010 1..3,5..6,8,12    ; 3793
.shutter 1110110100100 1..3,5..6,8,11    ; 3794
.shutter 1110110100110 1..3,5..6,8,11..12 ; 3795
.shutter 1110110101000 1..3,5..6,8,10    ; 3796
.shutter 1110110101010 1..3,5..6,8..12/2 ; 3797
.shutter 1110110101100 1..3,5..6,8,10..11 ; 3798
.shutter 1110110101110 1..3,5..6,8,10..12 ; 3799
.shutter 1110110110000 1..3,5..6,8..9    ; 3800
.shutter 1110110110010 1..3,5..6,8..9,12 ; 3801
.shutter 1110110110100 1..3,5..6,8..9,11 ; 3802
.shutter 1110110110110 1..3,5..6,8..9,11..12 ; 3803
.shutter 1110110111000 1..3,5..6,8..10   ; 3804
.shutter 1110110111010 1..3,5..6,8..10,12 ; 3805
.shutter 1110110111100 1..3,5..6,8..11   ; 3806
.shutter 1110110111110 1..3,5..6,8..12   ; 3807
.shutter 1110111000000 1..3,5..7         ; 3808
.shutter 1110111000010 1..3,5..7,12      ; 3809
.shutter 1110111000100 1..3,5..7,11      ; 3810
.shutter 1110111000110 1..3,5..7,11..12  ; 3811
.shutter 1110111001000 1..3,5..7,10      ; 3812
.shutter 1110111001010 1..3,5..7,10,12   ; 3813
.shutter 1110111001100 1..3,5..7,10..11  ; 3814
.shutter 1110111001110 1..3,5..7,10..12  ; 3815
.shutter 1110111010000 1..3,5..7,9       ; 3816
.shutter 1110111010010 1..3,5..7,9,12    ; 3817
.shutter 1110111010100 1..3,5..7,9,11    ; 3818
.shutter 1110111010110 1..3,5..7,9,11..12 ; 3819
.shutter 1110111011000 1..3,5..7,9..10   ; 3820
.shutter 1110111011010 1..3,5..7,9..10,12 ; 3821
.shutter 1110111011100 1..3,5..7,9..11   ; 3822
.shutter 1110111011110 1..3,5..7,9..12   ; 3823
.shutter 1110111100000 1..3,5..8         ; 3824
.shutter 1110111100010 1..3,5..8,12      ; 3825
.shutter 1110111100100 1..3,5..8,11      ; 3826
.shutter 1110111100110 1..3,5..8,11..12  ; 3827
.shutter 1110111101000 1..3,5..8,10      ; 3828
.shutter 1110111101010 1..3,5..8,10,12   ; 3829
.shutter 1110111101100 1..3,5..8,10..11  ; 3830
.shutter 1110111101110 1..3,5..8,10..12  ; 3831
.shutter 1110111110000 1..3,5..9         ; 3832
.shutter 1110111110010 1..3,5..9,12      ; 3833
.shutter 1110111110100 1..3,5..9,11      ; 3834
.shutter 1110111110110 1..3,5..9,11..12  ; 3835
.shutter 1110111111000 1..3,5..10        ; 3836
.shutter 1110111111010 1..3,5..10,12     ; 3837
.shutter 1110111111100 1..3,5..11        ; 3838
.shutter 1110111111110 1..3,5..12        ; 3839
.shutter 1111000000000 1..4              ; 3840
.shutter 1111000000010 1..4,12           ; 3841
.shutter 1111000000100 1..4,11           ; 3842
.shutter 1111000000110 1..4,11..12       ; 3843
.shutter 1111000001000 1..4,10           ; 3844
.shutter 1111000001010 1..4,10,12        ; 3845
.shutter 1111000001100 1..4,10..11       ; 3846
.shutter 1111000001110 1..4,10..12       ; 3847
.shutter 1111000010000 1..4,9            ; 3848
.shutter 1111000010010 1..4,9,12         ; 3849
.shutter 1111000010100 1..4,9,11         ; 3850
.shutter 1111000010110 1..4,9,11..12     ; 3851
.shutter 1111000011000 1..4,9..10        ; 3852
.shutter 1111000011010 1..4,9..10,12     ; 3853
.shutter 1111000011100 1..4,9..11        ; 3854
.shutter 1111000011110 1..4,9..12        ; 3855
.shutter 1111000100000 1..4,8            ; 3856
.shutter 1111000100010 1..4,8,12         ; 3857
.shutter 1111000100100 1..4,8,11         ; 3858
.shutter 1111000100110 1..4,8,11..12     ; 3859
.shutter 1111000101000 1..4,8,10         ; 3860
.shutter 1111000101010 1..4,8,10,12      ; 3861
.shutter 1111000101100 1..4,8,10..11     ; 3862
.shutter 1111000101110 1..4,8,10..12     ; 3863
.shutter 1111000110000 1..4,8..9         ; 3864
.shutter 1111000110010 1..4,8..9,12      ; 3865
.shutter 1111000110100 1..4,8..9,11      ; 3866
.shutter 1111000110110 1..4,8..9,11..12  ; 3867
.shutter 1111000111000 1..4,8..10        ; 3868
.shutter 1111000111010 1..4,8..10,12     ; 3869
.shutter 1111000111100 1..4,8..11        ; 3870
.shutter 1111000111110 1..4,8..12        ; 3871
.shutter 1111001000000 1..4,7            ; 3872
.shutter 1111001000010 1..4,7,12         ; 3873
.shutter 1111001000100 1..4,7,11         ; 3874
.shutter 1111001000110 1..4,7,11..12     ; 3875
.shutter 1111001001000 1..4,7,10         ; 3876
.shutter 1111001001010 1..4,7,10,12      ; 3877
.shutter 1111001001100 1..4,7,10..11     ; 3878
.shutter 1111001001110 1..4,7,10..12     ; 3879
.shutter 1111001010000 1..4,7,9          ; 3880
.shutter 1111001010010 1..4,7,9,12       ; 3881
.shutter 1111001010100 1..4,7,9,11       ; 3882
.shutter 1111001010110 1..4,7,9,11..12   ; 3883
.shutter 1111001011000 1..4,7,9..10      ; 3884
.shutter 1111001011010 1..4,7,9..10,12   ; 3885
.shutter 1111001011100 1..4,7,9..11      ; 3886
.shutter 1111001011110 1..4,7,9..12      ; 3887
.shutter 1111001100000 1..4,7..8         ; 3888
.shutter 1111001100010 1..4,7..8,12      ; 3889
.shutter 1111001100100 1..4,7..8,11      ; 3890
.shutter 1111001100110 1..4,7..8,11..12  ; 3891
.shutter 1111001101000 1..4,7..8,10      ; 3892
.shutter 1111001101010 1..4,7..8,10,12   ; 3893
.shutter 1111001101100 1..4,7..8,10..11  ; 3894
.shutter 1111001101110 1..4,7..8,10..12  ; 3895
.shutter 1111001110000 1..4,7..9         ; 3896
.shutter 1111001110010 1..4,7..9,12      ; 3897
.shutter 1111001110100 1..4,7..9,11      ; 3898
.shutter 1111001110110 1..4,7..9,11..12  ; 3899
.shutter 1111001111000 1..4,7..10        ; 3900
.shutter 1111001111010 1..4,7..10,12     ; 3901
.shutter 1111001111100 1..4,7..11        ; 3902
.shutter 1111001111110 1..4,7..12        ; 3903
.shutter 1111010000000 1..4,6            ; 3904
.shutter 1111010000010 1..4,6,12         ; 3905
.shutter 1111010000100 1..4,6,11         ; 3906
.shutter 1111010000110 1..4,6,11..12     ; 3907
.shutter 1111010001000 1..4,6,10         ; 3908
.shutter 1111010001010 1..4,6,10,12      ; 3909
.shutter 1111010001100 1..4,6,10..11     ; 3910
.shutter 1111010001110 1..4,6,10..12     ; 3911
.shutter 1111010010000 1..4,6,9          ; 3912
.shutter 1111010010010 1..4,6,9,12       ; 3913
.shutter 1111010010100 1..4,6,9,11       ; 3914
.shutter 1111010010110 1..4,6,9,11..12   ; 3915
.shutter 1111010011000 1..4,6,9..10      ; 3916
.shutter 1111010011010 1..4,6,9..10,12   ; 3917
.shutter 1111010011100 1..4,6,9..11      ; 3918
.shutter 1111010011110 1..4,6,9..12      ; 3919
.shutter 1111010100000 1..4,6,8          ; 3920
.shutter 1111010100010 1..4,6,8,12       ; 3921
.shutter 1111010100100 1..4,6,8,11       ; 3922
.shutter 1111010100110 1..4,6,8,11..12   ; 3923
.shutter 1111010101000 1..4,6,8,10       ; 3924
.shutter 1111010101010 1..4,6..12/2      ; 3925
.shutter 1111010101100 1..4,6,8,10..11   ; 3926
.shutter 1111010101110 1..4,6,8,10..12   ; 3927
.shutter 1111010110000 1..4,6,8..9       ; 3928
.shutter 1111010110010 1..4,6,8..9,12    ; 3929
.shutter 1111010110100 1..4,6,8..9,11    ; 3930
.shutter 1111010110110 1..4,6,8..9,11..12 ; 3931
.shutter 1111010111000 1..4,6,8..10      ; 3932
.shutter 1111010111010 1..4,6,8..10,12   ; 3933
.shutter 1111010111100 1..4,6,8..11      ; 3934
.shutter 1111010111110 1..4,6,8..12      ; 3935
.shutter 1111011000000 1..4,6..7         ; 3936
.shutter 1111011000010 1..4,6..7,12      ; 3937
.shutter 1111011000100 1..4,6..7,11      ; 3938
.shutter 1111011000110 1..4,6..7,11..12  ; 3939
.shutter 1111011001000 1..4,6..7,10      ; 3940
.shutter 1111011001010 1..4,6..7,10,12   ; 3941
.shutter 1111011001100 1..4,6..7,10..11  ; 3942
.shutter 1111011001110 1..4,6..7,10..12  ; 3943
.shutter 1111011010000 1..4,6..7,9       ; 3944
.shutter 1111011010010 1..4,6..7,9,12    ; 3945
.shutter 1111011010100 1..4,6..7,9,11    ; 3946
.shutter 1111011010110 1..4,6..7,9,11..12 ; 3947
.shutter 1111011011000 1..4,6..7,9..10   ; 3948
.shutter 1111011011010 1..4,6..7,9..10,12 ; 3949
.shutter 1111011011100 1..4,6..7,9..11   ; 3950
.shutter 1111011011110 1..4,6..7,9..12   ; 3951
.shutter 1111011100000 1..4,6..8         ; 3952
.shutter 1111011100010 1..4,6..8,12      ; 3953
.shutter 1111011100100 1..4,6..8,11      ; 3954
.shutter 1111011100110 1..4,6..8,11..12  ; 3955
.shutter 1111011101000 1..4,6..8,10      ; 3956
.shutter 1111011101010 1..4,6..8,10,12   ; 3957
.shutter 1111011101100 1..4,6..8,10..11  ; 3958
.shutter 1111011101110 1..4,6..8,10..12  ; 3959
.shutter 1111011110000 1..4,6..9         ; 3960
.shutter 1111011110010 1..4,6..9,12      ; 3961
.shutter 1111011110100 1..4,6..9,11      ; 3962
.shutter 1111011110110 1..4,6..9,11..12  ; 3963
.shutter 1111011111000 1..4,6..10        ; 3964
.shutter 1111011111010 1..4,6..10,12     ; 3965
.shutter 1111011111100 1..4,6..11        ; 3966
.shutter 1111011111110 1..4,6..12        ; 3967
.shutter 1111100000000 1..5              ; 3968
.shutter 1111100000010 1..5,12           ; 3969
.shutter 1111100000100 1..5,11           ; 3970
.shutter 1111100000110 1..5,11..12       ; 3971
.shutter 1111100001000 1..5,10           ; 3972
.shutter 1111100001010 1..5,10,12        ; 3973
.shutter 1111100001100 1..5,10..11       ; 3974
.shutter 1111100001110 1..5,10..12       ; 3975
.shutter 1111100010000 1..5,9            ; 3976
.shutter 1111100010010 1..5,9,12         ; 3977
.shutter 1111100010100 1..5,9,11         ; 3978
.shutter 1111100010110 1..5,9,11..12     ; 3979
.shutter 1111100011000 1..5,9..10        ; 3980
.shutter 1111100011010 1..5,9..10,12     ; 3981
.shutter 1111100011100 1..5,9..11        ; 3982
.shutter 1111100011110 1..5,9..12        ; 3983
.shutter 1111100100000 1..5,8            ; 3984
.shutter 1111100100010 1..5,8,12         ; 3985
.shutter 1111100100100 1..5,8,11         ; 3986
.shutter 1111100100110 1..5,8,11..12     ; 3987
.shutter 1111100101000 1..5,8,10         ; 3988
.shutter 1111100101010 1..5,8,10,12      ; 3989
.shutter 1111100101100 1..5,8,10..11     ; 3990
.shutter 1111100101110 1..5,8,10..12     ; 3991
.shutter 1111100110000 1..5,8..9         ; 3992
.shutter 1111100110010 1..5,8..9,12      ; 3993
.shutter 1111100110100 1..5,8..9,11      ; 3994
.shutter 1111100110110 1..5,8..9,11..12  ; 3995
.shutter 1111100111000 1..5,8..10        ; 3996
.shutter 1111100111010 1..5,8..10,12     ; 3997
.shutter 1111100111100 1..5,8..11        ; 3998
.shutter 1111100111110 1..5,8..12        ; 3999
.shutter 1111101000000 1..5,7            ; 4000
.shutter 1111101000010 1..5,7,12         ; 4001
.shutter 1111101000100 1..5,7,11         ; 4002
.shutter 1111101000110 1..5,7,11..12     ; 4003
.shutter 1111101001000 1..5,7,10         ; 4004
.shutter 1111101001010 1..5,7,10,12      ; 4005
.shutter 1111101001100 1..5,7,10..11     ; 4006
.shutter 1111101001110 1..5,7,10..12     ; 4007
.shutter 1111101010000 1..5,7,9          ; 4008
.shutter 1111101010010 1..5,7,9,12       ; 4009
.shutter 1111101010100 1..5,7,9,11       ; 4010
.shutter 1111101010110 1..5,7,9,11..12   ; 4011
.shutter 1111101011000 1..5,7,9..10      ; 4012
.shutter 1111101011010 1..5,7,9..10,12   ; 4013
.shutter 1111101011100 1..5,7,9..11      ; 4014
.shutter 1111101011110 1..5,7,9..12      ; 4015
.shutter 1111101100000 1..5,7..8         ; 4016
.shutter 1111101100010 1..5,7..8,12      ; 4017
.shutter 1111101100100 1..5,7..8,11      ; 4018
.shutter 1111101100110 1..5,7..8,11..12  ; 4019
.shutter 1111101101000 1..5,7..8,10      ; 4020
.shutter 1111101101010 1..5,7..8,10,12   ; 4021
.shutter 1111101101100 1..5,7..8,10..11  ; 4022
.shutter 1111101101110 1..5,7..8,10..12  ; 4023
.shutter 1111101110000 1..5,7..9         ; 4024
.shutter 1111101110010 1..5,7..9,12      ; 4025
.shutter 1111101110100 1..5,7..9,11      ; 4026
.shutter 1111101110110 1..5,7..9,11..12  ; 4027
.shutter 1111101111000 1..5,7..10        ; 4028
.shutter 1111101111010 1..5,7..10,12     ; 4029
.shutter 1111101111100 1..5,7..11        ; 4030
.shutter 1111101111110 1..5,7..12        ; 4031
.shutter 1111110000000 1..6              ; 4032
.shutter 1111110000010 1..6,12           ; 4033
.shutter 1111110000100 1..6,11           ; 4034
.shutter 1111110000110 1..6,11..12       ; 4035
.shutter 1111110001000 1..6,10           ; 4036
.shutter 1111110001010 1..6,10,12        ; 4037
.shutter 1111110001100 1..6,10..11       ; 4038
.shutter 1111110001110 1..6,10..12       ; 4039
.shutter 1111110010000 1..6,9            ; 4040
.shutter 1111110010010 1..6,9,12         ; 4041
.shutter 1111110010100 1..6,9,11         ; 4042
.shutter 1111110010110 1..6,9,11..12     ; 4043
.shutter 1111110011000 1..6,9..10        ; 4044
.shutter 1111110011010 1..6,9..10,12     ; 4045
.shutter 1111110011100 1..6,9..11        ; 4046
.shutter 1111110011110 1..6,9..12        ; 4047
.shutter 1111110100000 1..6,8            ; 4048
.shutter 1111110100010 1..6,8,12         ; 4049
.shutter 1111110100100 1..6,8,11         ; 4050
.shutter 1111110100110 1..6,8,11..12     ; 4051
.shutter 1111110101000 1..6,8,10         ; 4052
.shutter 1111110101010 1..6,8,10,12      ; 4053
.shutter 1111110101100 1..6,8,10..11     ; 4054
.shutter 1111110101110 1..6,8,10..12     ; 4055
.shutter 1111110110000 1..6,8..9         ; 4056
.shutter 1111110110010 1..6,8..9,12      ; 4057
.shutter 1111110110100 1..6,8..9,11      ; 4058
.shutter 1111110110110 1..6,8..9,11..12  ; 4059
.shutter 1111110111000 1..6,8..10        ; 4060
.shutter 1111110111010 1..6,8..10,12     ; 4061
.shutter 1111110111100 1..6,8..11        ; 4062
.shutter 1111110111110 1..6,8..12        ; 4063
.shutter 1111111000000 1..7              ; 4064
.shutter 1111111000010 1..7,12           ; 4065
.shutter 1111111000100 1..7,11           ; 4066
.shutter 1111111000110 1..7,11..12       ; 4067
.shutter 1111111001000 1..7,10           ; 4068
.shutter 1111111001010 1..7,10,12        ; 4069
.shutter 1111111001100 1..7,10..11       ; 4070
.shutter 1111111001110 1..7,10..12       ; 4071
.shutter 1111111010000 1..7,9            ; 4072
.shutter 1111111010010 1..7,9,12         ; 4073
.shutter 1111111010100 1..7,9,11         ; 4074
.shutter 1111111010110 1..7,9,11..12     ; 4075
.shutter 1111111011000 1..7,9..10        ; 4076
.shutter 1111111011010 1..7,9..10,12     ; 4077
.shutter 1111111011100 1..7,9..11        ; 4078
.shutter 1111111011110 1..7,9..12        ; 4079
.shutter 1111111100000 1..8              ; 4080
.shutter 1111111100010 1..8,12           ; 4081
.shutter 1111111100100 1..8,11           ; 4082
.shutter 1111111100110 1..8,11..12       ; 4083
.shutter 1111111101000 1..8,10           ; 4084
.shutter 1111111101010 1..8,10,12        ; 4085
.shutter 1111111101100 1..8,10..11       ; 4086
.shutter 1111111101110 1..8,10..12       ; 4087
.shutter 1111111110000 1..9              ; 4088
.shutter 1111111110010 1..9,12           ; 4089
.shutter 1111111110100 1..9,11           ; 4090
.shutter 1111111110110 1..9,11..12       ; 4091
.shutter 1111111111000 1..10             ; 4092
.shutter 1111111111010 1..10,12          ; 4093
.shutter 1111111111100 1..11             ; 4094
.shutter 1111111111110 1..12             ; 4095
.shutter 0000000000001 0                 ; 4096
.shutter 0000000000011 0,12              ; 4097
.shutter 0000000000101 0,11              ; 4098
.shutter 0000000000111 0,11..12          ; 4099
.shutter 0000000001001 0,10              ; 4100
.shutter 0000000001011 0,10,12           ; 4101
.shutter 0000000001101 0,10..11          ; 4102
.shutter 0000000001111 0,10..12          ; 4103
.shutter 0000000010001 0,9               ; 4104
.shutter 0000000010011 0,9,12            ; 4105
.shutter 0000000010101 0,9,11            ; 4106
.shutter 0000000010111 0,9,11..12        ; 4107
.shutter 0000000011001 0,9..10           ; 4108
.shutter 0000000011011 0,9..10,12        ; 4109
.shutter 0000000011101 0,9..11           ; 4110
.shutter 0000000011111 0,9..12           ; 4111
.shutter 0000000100001 0,8               ; 4112
.shutter 0000000100011 0,8,12            ; 4113
.shutter 0000000100101 0,8,11            ; 4114
.shutter 0000000100111 0,8,11..12        ; 4115
.shutter 0000000101001 0,8,10            ; 4116
.shutter 0000000101011 0,8,10,12         ; 4117
.shutter 0000000101101 0,8,10..11        ; 4118
.shutter 0000000101111 0,8,10..12        ; 4119
.shutter 0000000110001 0,8..9            ; 4120
.shutter 0000000110011 0,8..9,12         ; 4121
.shutter 0000000110101 0,8..9,11         ; 4122
.shutter 0000000110111 0,8..9,11..12     ; 4123
.shutter 0000000111001 0,8..10           ; 4124
.shutter 0000000111011 0,8..10,12        ; 4125
.shutter 0000000111101 0,8..11           ; 4126
.shutter 0000000111111 0,8..12           ; 4127
.shutter 0000001000001 0,7               ; 4128
.shutter 0000001000011 0,7,12            ; 4129
.shutter 0000001000101 0,7,11            ; 4130
.shutter 0000001000111 0,7,11..12        ; 4131
.shutter 0000001001001 0,7,10            ; 4132
.shutter 0000001001011 0,7,10,12         ; 4133
.shutter 0000001001101 0,7,10..11        ; 4134
.shutter 0000001001111 0,7,10..12        ; 4135
.shutter 0000001010001 0,7,9             ; 4136
.shutter 0000001010011 0,7,9,12          ; 4137
.shutter 0000001010101 0,7,9,11          ; 4138
.shutter 0000001010111 0,7,9,11..12      ; 4139
.shutter 0000001011001 0,7,9..10         ; 4140
.shutter 0000001011011 0,7,9..10,12      ; 4141
.shutter 0000001011101 0,7,9..11         ; 4142
.shutter 0000001011111 0,7,9..12         ; 4143
.shutter 0000001100001 0,7..8            ; 4144
.shutter 0000001100011 0,7..8,12         ; 4145
.shutter 0000001100101 0,7..8,11         ; 4146
.shutter 0000001100111 0,7..8,11..12     ; 4147
.shutter 0000001101001 0,7..8,10         ; 4148
.shutter 0000001101011 0,7..8,10,12      ; 4149
.shutter 0000001101101 0,7..8,10..11     ; 4150
.shutter 0000001101111 0,7..8,10..12     ; 4151
.shutter 0000001110001 0,7..9            ; 4152
.shutter 0000001110011 0,7..9,12         ; 4153
.shutter 0000001110101 0,7..9,11         ; 4154
.shutter 0000001110111 0,7..9,11..12     ; 4155
.shutter 0000001111001 0,7..10           ; 4156
.shutter 0000001111011 0,7..10,12        ; 4157
.shutter 0000001111101 0,7..11           ; 4158
.shutter 0000001111111 0,7..12           ; 4159
.shutter 0000010000001 0,6               ; 4160
.shutter 0000010000011 0,6,12            ; 4161
.shutter 0000010000101 0,6,11            ; 4162
.shutter 0000010000111 0,6,11..12        ; 4163
.shutter 0000010001001 0,6,10            ; 4164
.shutter 0000010001011 0,6,10,12         ; 4165
.shutter 0000010001101 0,6,10..11        ; 4166
.shutter 0000010001111 0,6,10..12        ; 4167
.shutter 0000010010001 0,6,9             ; 4168
.shutter 0000010010011 0,6,9,12          ; 4169
.shutter 0000010010101 0,6,9,11          ; 4170
.shutter 0000010010111 0,6,9,11..12      ; 4171
.shutter 0000010011001 0,6,9..10         ; 4172
.shutter 0000010011011 0,6,9..10,12      ; 4173
.shutter 0000010011101 0,6,9..11         ; 4174
.shutter 0000010011111 0,6,9..12         ; 4175
.shutter 0000010100001 0,6,8             ; 4176
.shutter 0000010100011 0,6,8,12          ; 4177
.shutter 0000010100101 0,6,8,11          ; 4178
.shutter 0000010100111 0,6,8,11..12      ; 4179
.shutter 0000010101001 0,6,8,10          ; 4180
.shutter 0000010101011 0,6..12/2         ; 4181
.shutter 0000010101101 0,6,8,10..11      ; 4182
.shutter 0000010101111 0,6,8,10..12      ; 4183
.shutter 0000010110001 0,6,8..9          ; 4184
.shutter 0000010110011 0,6,8..9,12       ; 4185
.shutter 0000010110101 0,6,8..9,11       ; 4186
.shutter 0000010110111 0,6,8..9,11..12   ; 4187
.shutter 0000010111001 0,6,8..10         ; 4188
.shutter 0000010111011 0,6,8..10,12      ; 4189
.shutter 0000010111101 0,6,8..11         ; 4190
.shutter 0000010111111 0,6,8..12         ; 4191
.shutter 0000011000001 0,6..7            ; 4192
.shutter 0000011000011 0,6..7,12         ; 4193
.shutter 0000011000101 0,6..7,11         ; 4194
.shutter 0000011000111 0,6..7,11..12     ; 4195
.shutter 0000011001001 0,6..7,10         ; 4196
.shutter 0000011001011 0,6..7,10,12      ; 4197
.shutter 0000011001101 0,6..7,10..11     ; 4198
.shutter 0000011001111 0,6..7,10..12     ; 4199
.shutter 0000011010001 0,6..7,9          ; 4200
.shutter 0000011010011 0,6..7,9,12       ; 4201
.shutter 0000011010101 0,6..7,9,11       ; 4202
.shutter 0000011010111 0,6..7,9,11..12   ; 4203
.shutter 0000011011001 0,6..7,9..10      ; 4204
.shutter 0000011011011 0,6..7,9..10,12   ; 4205
.shutter 0000011011101 0,6..7,9..11      ; 4206
.shutter 0000011011111 0,6..7,9..12      ; 4207
.shutter 0000011100001 0,6..8            ; 4208
.shutter 0000011100011 0,6..8,12         ; 4209
.shutter 0000011100101 0,6..8,11         ; 4210
.shutter 0000011100111 0,6..8,11..12     ; 4211
.shutter 0000011101001 0,6..8,10         ; 4212
.shutter 0000011101011 0,6..8,10,12      ; 4213
.shutter 0000011101101 0,6..8,10..11     ; 4214
.shutter 0000011101111 0,6..8,10..12     ; 4215
.shutter 0000011110001 0,6..9            ; 4216
.shutter 0000011110011 0,6..9,12         ; 4217
.shutter 0000011110101 0,6..9,11         ; 4218
.shutter 0000011110111 0,6..9,11..12     ; 4219
.shutter 0000011111001 0,6..10           ; 4220
.shutter 0000011111011 0,6..10,12        ; 4221
.shutter 0000011111101 0,6..11           ; 4222
.shutter 0000011111111 0,6..12           ; 4223
.shutter 0000100000001 0,5               ; 4224
.shutter 0000100000011 0,5,12            ; 4225
.shutter 0000100000101 0,5,11            ; 4226
.shutter 0000100000111 0,5,11..12        ; 4227
.shutter 0000100001001 0,5,10            ; 4228
.shutter 0000100001011 0,5,10,12         ; 4229
.shutter 0000100001101 0,5,10..11        ; 4230
.shutter 0000100001111 0,5,10..12        ; 4231
.shutter 0000100010001 0,5,9             ; 4232
.shutter 0000100010011 0,5,9,12          ; 4233
.shutter 0000100010101 0,5,9,11          ; 4234
.shutter 0000100010111 0,5,9,11..12      ; 4235
.shutter 0000100011001 0,5,9..10         ; 4236
.shutter 0000100011011 0,5,9..10,12      ; 4237
.shutter 0000100011101 0,5,9..11         ; 4238
.shutter 0000100011111 0,5,9..12         ; 4239
.shutter 0000100100001 0,5,8             ; 4240
.shutter 0000100100011 0,5,8,12          ; 4241
.shutter 0000100100101 0,5,8,11          ; 4242
.shutter 0000100100111 0,5,8,11..12      ; 4243
.shutter 0000100101001 0,5,8,10          ; 4244
.shutter 0000100101011 0,5,8..12/2       ; 4245
.shutter 0000100101101 0,5,8,10..11      ; 4246
.shutter 0000100101111 0,5,8,10..12      ; 4247
.shutter 0000100110001 0,5,8..9          ; 4248
.shutter 0000100110011 0,5,8..9,12       ; 4249
.shutter 0000100110101 0,5,8..9,11       ; 4250
.shutter 0000100110111 0,5,8..9,11..12   ; 4251
.shutter 0000100111001 0,5,8..10         ; 4252
.shutter 0000100111011 0,5,8..10,12      ; 4253
.shutter 0000100111101 0,5,8..11         ; 4254
.shutter 0000100111111 0,5,8..12         ; 4255
.shutter 0000101000001 0,5,7             ; 4256
.shutter 0000101000011 0,5,7,12          ; 4257
.shutter 0000101000101 0,5,7,11          ; 4258
.shutter 0000101000111 0,5,7,11..12      ; 4259
.shutter 0000101001001 0,5,7,10          ; 4260
.shutter 0000101001011 0,5,7,10,12       ; 4261
.shutter 0000101001101 0,5,7,10..11      ; 4262
.shutter 0000101001111 0,5,7,10..12      ; 4263
.shutter 0000101010001 0,5,7,9           ; 4264
.shutter 0000101010011 0,5..9/2,12       ; 4265
.shutter 0000101010101 0,5..11/2         ; 4266
.shutter 0000101010111 0,5..11/2,12      ; 4267
.shutter 0000101011001 0,5,7,9..10       ; 4268
.shutter 0000101011011 0,5..9/2,10,12    ; 4269
.shutter 0000101011101 0,5,7,9..11       ; 4270
.shutter 0000101011111 0,5,7,9..12       ; 4271
.shutter 0000101100001 0,5,7..8          ; 4272
.shutter 0000101100011 0,5,7..8,12       ; 4273
.shutter 0000101100101 0,5,7..8,11       ; 4274
.shutter 0000101100111 0,5,7..8,11..12   ; 4275
.shutter 0000101101001 0,5,7..8,10       ; 4276
.shutter 0000101101011 0,5,7..8,10,12    ; 4277
.shutter 0000101101101 0,5,7..8,10..11   ; 4278
.shutter 0000101101111 0,5,7..8,10..12   ; 4279
.shutter 0000101110001 0,5,7..9          ; 4280
.shutter 0000101110011 0,5,7..9,12       ; 4281
.shutter 0000101110101 0,5,7..9,11       ; 4282
.shutter 0000101110111 0,5,7..9,11..12   ; 4283
.shutter 0000101111001 0,5,7..10         ; 4284
.shutter 0000101111011 0,5,7..10,12      ; 4285
.shutter 0000101111101 0,5,7..11         ; 4286
.shutter 0000101111111 0,5,7..12         ; 4287
.shutter 0000110000001 0,5..6            ; 4288
.shutter 0000110000011 0,5..6,12         ; 4289
.shutter 0000110000101 0,5..6,11         ; 4290
.shutter 0000110000111 0,5..6,11..12     ; 4291
.shutter 0000110001001 0,5..6,10         ; 4292
.shutter 0000110001011 0,5..6,10,12      ; 4293
.shutter 0000110001101 0,5..6,10..11     ; 4294
.shutter 0000110001111 0,5..6,10..12     ; 4295
.shutter 0000110010001 0,5..6,9          ; 4296
.shutter 0000110010011 0,5..6,9,12       ; 4297
.shutter 0000110010101 0,5..6,9,11       ; 4298
.shutter 0000110010111 0,5..6,9,11..12   ; 4299
.shutter 0000110011001 0,5..6,9..10      ; 4300
.shutter 0000110011011 0,5..6,9..10,12   ; 4301
.shutter 0000110011101 0,5..6,9..11      ; 4302
.shutter 0000110011111 0,5..6,9..12      ; 4303
.shutter 0000110100001 0,5..6,8          ; 4304
.shutter 0000110100011 0,5..6,8,12       ; 4305
.shutter 0000110100101 0,5..6,8,11       ; 4306
.shutter 0000110100111 0,5..6,8,11..12   ; 4307
.shutter 0000110101001 0,5..6,8,10       ; 4308
.shutter 0000110101011 0,5..6,8..12/2    ; 4309
.shutter 0000110101101 0,5..6,8,10..11   ; 4310
.shutter 0000110101111 0,5..6,8,10..12   ; 4311
.shutter 0000110110001 0,5..6,8..9       ; 4312
.shutter 0000110110011 0,5..6,8..9,12    ; 4313
.shutter 0000110110101 0,5..6,8..9,11    ; 4314
.shutter 0000110110111 0,5..6,8..9,11..12 ; 4315
.shutter 0000110111001 0,5..6,8..10      ; 4316
.shutter 0000110111011 0,5..6,8..10,12   ; 4317
.shutter 0000110111101 0,5..6,8..11      ; 4318
.shutter 0000110111111 0,5..6,8..12      ; 4319
.shutter 0000111000001 0,5..7            ; 4320
.shutter 0000111000011 0,5..7,12         ; 4321
.shutter 0000111000101 0,5..7,11         ; 4322
.shutter 0000111000111 0,5..7,11..12     ; 4323
.shutter 0000111001001 0,5..7,10         ; 4324
.shutter 0000111001011 0,5..7,10,12      ; 4325
.shutter 0000111001101 0,5..7,10..11     ; 4326
.shutter 0000111001111 0,5..7,10..12     ; 4327
.shutter 0000111010001 0,5..7,9          ; 4328
.shutter 0000111010011 0,5..7,9,12       ; 4329
.shutter 0000111010101 0,5..7,9,11       ; 4330
.shutter 0000111010111 0,5..7,9,11..12   ; 4331
.shutter 0000111011001 0,5..7,9..10      ; 4332
.shutter 0000111011011 0,5..7,9..10,12   ; 4333
.shutter 0000111011101 0,5..7,9..11      ; 4334
.shutter 0000111011111 0,5..7,9..12      ; 4335
.shutter 0000111100001 0,5..8            ; 4336
.shutter 0000111100011 0,5..8,12         ; 4337
.shutter 0000111100101 0,5..8,11         ; 4338
.shutter 0000111100111 0,5..8,11..12     ; 4339
.shutter 0000111101001 0,5..8,10         ; 4340
.shutter 0000111101011 0,5..8,10,12      ; 4341
.shutter 0000111101101 0,5..8,10..11     ; 4342
.shutter 0000111101111 0,5..8,10..12     ; 4343
.shutter 0000111110001 0,5..9            ; 4344
.shutter 0000111110011 0,5..9,12         ; 4345
.shutter 0000111110101 0,5..9,11         ; 4346
.shutter 0000111110111 0,5..9,11..12     ; 4347
.shutter 0000111111001 0,5..10           ; 4348
.shutter 0000111111011 0,5..10,12        ; 4349
.shutter 0000111111101 0,5..11           ; 4350
.shutter 0000111111111 0,5..12           ; 4351
.shutter 0001000000001 0,4               ; 4352
.shutter 0001000000011 0,4,12            ; 4353
.shutter 0001000000101 0,4,11            ; 4354
.shutter 0001000000111 0,4,11..12        ; 4355
.shutter 0001000001001 0,4,10            ; 4356
.shutter 0001000001011 0,4,10,12         ; 4357
.shutter 0001000001101 0,4,10..11        ; 4358
.shutter 0001000001111 0,4,10..12        ; 4359
.shutter 0001000010001 0,4,9             ; 4360
.shutter 0001000010011 0,4,9,12          ; 4361
.shutter 0001000010101 0,4,9,11          ; 4362
.shutter 0001000010111 0,4,9,11..12      ; 4363
.shutter 0001000011001 0,4,9..10         ; 4364
.shutter 0001000011011 0,4,9..10,12      ; 4365
.shutter 0001000011101 0,4,9..11         ; 4366
.shutter 0001000011111 0,4,9..12         ; 4367
.shutter 0001000100001 0,4,8             ; 4368
.shutter 0001000100011 0,4,8,12          ; 4369
.shutter 0001000100101 0,4,8,11          ; 4370
.shutter 0001000100111 0,4,8,11..12      ; 4371
.shutter 0001000101001 0,4,8,10          ; 4372
.shutter 0001000101011 0..8/4,10,12      ; 4373
.shutter 0001000101101 0,4,8,10..11      ; 4374
.shutter 0001000101111 0,4,8,10..12      ; 4375
.shutter 0001000110001 0,4,8..9          ; 4376
.shutter 0001000110011 0,4,8..9,12       ; 4377
.shutter 0001000110101 0,4,8..9,11       ; 4378
.shutter 0001000110111 0,4,8..9,11..12   ; 4379
.shutter 0001000111001 0,4,8..10         ; 4380
.shutter 0001000111011 0,4,8..10,12      ; 4381
.shutter 0001000111101 0,4,8..11         ; 4382
.shutter 0001000111111 0,4,8..12         ; 4383
.shutter 0001001000001 0,4,7             ; 4384
.shutter 0001001000011 0,4,7,12          ; 4385
.shutter 0001001000101 0,4,7,11          ; 4386
.shutter 0001001000111 0,4,7,11..12      ; 4387
.shutter 0001001001001 0,4,7,10          ; 4388
.shutter 0001001001011 0,4..10/3,12      ; 4389
.shutter 0001001001101 0,4,7,10..11      ; 4390
.shutter 0001001001111 0,4,7,10..12      ; 4391
.shutter 0001001010001 0,4,7,9           ; 4392
.shutter 0001001010011 0,4,7,9,12        ; 4393
.shutter 0001001010101 0,4,7..11/2       ; 4394
.shutter 0001001010111 0,4,7..11/2,12    ; 4395
.shutter 0001001011001 0,4,7,9..10       ; 4396
.shutter 0001001011011 0,4,7,9..10,12    ; 4397
.shutter 0001001011101 0,4,7,9..11       ; 4398
.shutter 0001001011111 0,4,7,9..12       ; 4399
.shutter 0001001100001 0,4,7..8          ; 4400
.shutter 0001001100011 0,4,7..8,12       ; 4401
.shutter 0001001100101 0,4,7..8,11       ; 4402
.shutter 0001001100111 0,4,7..8,11..12   ; 4403
.shutter 0001001101001 0,4,7..8,10       ; 4404
.shutter 0001001101011 0,4,7..8,10,12    ; 4405
.shutter 0001001101101 0,4,7..8,10..11   ; 4406
.shutter 0001001101111 0,4,7..8,10..12   ; 4407
.shutter 0001001110001 0,4,7..9          ; 4408
.shutter 0001001110011 0,4,7..9,12       ; 4409
.shutter 0001001110101 0,4,7..9,11       ; 4410
.shutter 0001001110111 0,4,7..9,11..12   ; 4411
.shutter 0001001111001 0,4,7..10         ; 4412
.shutter 0001001111011 0,4,7..10,12      ; 4413
.shutter 0001001111101 0,4,7..11         ; 4414
.shutter 0001001111111 0,4,7..12         ; 4415
.shutter 0001010000001 0,4,6             ; 4416
.shutter 0001010000011 0,4,6,12          ; 4417
.shutter 0001010000101 0,4,6,11          ; 4418
.shutter 0001010000111 0,4,6,11..12      ; 4419
.shutter 0001010001001 0,4,6,10          ; 4420
.shutter 0001010001011 0,4,6,10,12       ; 4421
.shutter 0001010001101 0,4,6,10..11      ; 4422
.shutter 0001010001111 0,4,6,10..12      ; 4423
.shutter 0001010010001 0,4,6,9           ; 4424
.shutter 0001010010011 0,4,6..12/3       ; 4425
.shutter 0001010010101 0,4,6,9,11        ; 4426
.shutter 0001010010111 0,4,6,9,11..12    ; 4427
.shutter 0001010011001 0,4,6,9..10       ; 4428
.shutter 0001010011011 0,4,6,9..10,12    ; 4429
.shutter 0001010011101 0,4,6,9..11       ; 4430
.shutter 0001010011111 0,4,6,9..12       ; 4431
.shutter 0001010100001 0,4,6,8           ; 4432
.shutter 0001010100011 0,4..8/2,12       ; 4433
.shutter 0001010100101 0,4..8/2,11       ; 4434
.shutter 0001010100111 0,4..8/2,11..12   ; 4435
.shutter 0001010101001 0,4..10/2         ; 4436
.shutter 0001010101011 0,4..12/2         ; 4437
.shutter 0001010101101 0,4..10/2,11      ; 4438
.shutter 0001010101111 0,4..10/2,11..12  ; 4439
.shutter 0001010110001 0,4,6,8..9        ; 4440
.shutter 0001010110011 0,4..8/2,9,12     ; 4441
.shutter 0001010110101 0,4..8/2,9,11     ; 4442
.shutter 0001010110111 0,4..8/2,9,11..12 ; 4443
.shutter 0001010111001 0,4,6,8..10       ; 4444
.shutter 0001010111011 0,4..8/2,9..10,12 ; 4445
.shutter 0001010111101 0,4,6,8..11       ; 4446
.shutter 0001010111111 0,4,6,8..12       ; 4447
.shutter 0001011000001 0,4,6..7          ; 4448
.shutter 0001011000011 0,4,6..7,12       ; 4449
.shutter 0001011000101 0,4,6..7,11       ; 4450
.shutter 0001011000111 0,4,6..7,11..12   ; 4451
.shutter 0001011001001 0,4,6..7,10       ; 4452
.shutter 0001011001011 0,4,6..7,10,12    ; 4453
.shutter 0001011001101 0,4,6..7,10..11   ; 4454
.shutter 0001011001111 0,4,6..7,10..12   ; 4455
.shutter 0001011010001 0,4,6..7,9        ; 4456
.shutter 0001011010011 0,4,6..7,9,12     ; 4457
.shutter 0001011010101 0,4,6..7,9,11     ; 4458
.shutter 0001011010111 0,4,6..7,9,11..12 ; 4459
.shutter 0001011011001 0,4,6..7,9..10    ; 4460
.shutter 0001011011011 0,4,6..7,9..10,12 ; 4461
.shutter 0001011011101 0,4,6..7,9..11    ; 4462
.shutter 0001011011111 0,4,6..7,9..12    ; 4463
.shutter 0001011100001 0,4,6..8          ; 4464
.shutter 0001011100011 0,4,6..8,12       ; 4465
.shutter 0001011100101 0,4,6..8,11       ; 4466
.shutter 0001011100111 0,4,6..8,11..12   ; 4467
.shutter 0001011101001 0,4,6..8,10       ; 4468
.shutter 0001011101011 0,4,6..8,10,12    ; 4469
.shutter 0001011101101 0,4,6..8,10..11   ; 4470
.shutter 0001011101111 0,4,6..8,10..12   ; 4471
.shutter 0001011110001 0,4,6..9          ; 4472
.shutter 0001011110011 0,4,6..9,12       ; 4473
.shutter 0001011110101 0,4,6..9,11       ; 4474
.shutter 0001011110111 0,4,6..9,11..12   ; 4475
.shutter 0001011111001 0,4,6..10         ; 4476
.shutter 0001011111011 0,4,6..10,12      ; 4477
.shutter 0001011111101 0,4,6..11         ; 4478
.shutter 0001011111111 0,4,6..12         ; 4479
.shutter 0001100000001 0,4..5            ; 4480
.shutter 0001100000011 0,4..5,12         ; 4481
.shutter 0001100000101 0,4..5,11         ; 4482
.shutter 0001100000111 0,4..5,11..12     ; 4483
.shutter 0001100001001 0,4..5,10         ; 4484
.shutter 0001100001011 0,4..5,10,12      ; 4485
.shutter 0001100001101 0,4..5,10..11     ; 4486
.shutter 0001100001111 0,4..5,10..12     ; 4487
.shutter 0001100010001 0,4..5,9          ; 4488
.shutter 0001100010011 0,4..5,9,12       ; 4489
.shutter 0001100010101 0,4..5,9,11       ; 4490
.shutter 0001100010111 0,4..5,9,11..12   ; 4491
.shutter 0001100011001 0,4..5,9..10      ; 4492
.shutter 0001100011011 0,4..5,9..10,12   ; 4493
.shutter 0001100011101 0,4..5,9..11      ; 4494
.shutter 0001100011111 0,4..5,9..12      ; 4495
.shutter 0001100100001 0,4..5,8          ; 4496
.shutter 0001100100011 0,4..5,8,12       ; 4497
.shutter 0001100100101 0,4..5,8,11       ; 4498
.shutter 0001100100111 0,4..5,8,11..12   ; 4499
.shutter 0001100101001 0,4..5,8,10       ; 4500
.shutter 0001100101011 0,4..5,8..12/2    ; 4501
.shutter 0001100101101 0,4..5,8,10..11   ; 4502
.shutter 0001100101111 0,4..5,8,10..12   ; 4503
.shutter 0001100110001 0,4..5,8..9       ; 4504
.shutter 0001100110011 0,4..5,8..9,12    ; 4505
.shutter 0001100110101 0,4..5,8..9,11    ; 4506
.shutter 0001100110111 0,4..5,8..9,11..12 ; 4507
.shutter 0001100111001 0,4..5,8..10      ; 4508
.shutter 0001100111011 0,4..5,8..10,12   ; 4509
.shutter 0001100111101 0,4..5,8..11      ; 4510
.shutter 0001100111111 0,4..5,8..12      ; 4511
.shutter 0001101000001 0,4..5,7          ; 4512
.shutter 0001101000011 0,4..5,7,12       ; 4513
.shutter 0001101000101 0,4..5,7,11       ; 4514
.shutter 0001101000111 0,4..5,7,11..12   ; 4515
.shutter 0001101001001 0,4..5,7,10       ; 4516
.shutter 0001101001011 0,4..5,7,10,12    ; 4517
.shutter 0001101001101 0,4..5,7,10..11   ; 4518
.shutter 0001101001111 0,4..5,7,10..12   ; 4519
.shutter 0001101010001 0,4..5,7,9        ; 4520
.shutter 0001101010011 0,4..5,7,9,12     ; 4521
.shutter 0001101010101 0,4..5,7..11/2    ; 4522
.shutter 0001101010111 0,4..5,7..11/2,12 ; 4523
.shutter 0001101011001 0,4..5,7,9..10    ; 4524
.shutter 0001101011011 0,4..5,7,9..10,12 ; 4525
.shutter 0001101011101 0,4..5,7,9..11    ; 4526
.shutter 0001101011111 0,4..5,7,9..12    ; 4527
.shutter 0001101100001 0,4..5,7..8       ; 4528
.shutter 0001101100011 0,4..5,7..8,12    ; 4529
.shutter 0001101100101 0,4..5,7..8,11    ; 4530
.shutter 0001101100111 0,4..5,7..8,11..12 ; 4531
.shutter 0001101101001 0,4..5,7..8,10    ; 4532
.shutter 0001101101011 0,4..5,7..8,10,12 ; 4533
.shutter 0001101101101 0,4..5,7..8,10..11 ; 4534
.shutter 0001101101111 0,4..5,7..8,10..12 ; 4535
.shutter 0001101110001 0,4..5,7..9       ; 4536
.shutter 0001101110011 0,4..5,7..9,12    ; 4537
.shutter 0001101110101 0,4..5,7..9,11    ; 4538
.shutter 0001101110111 0,4..5,7..9,11..12 ; 4539
.shutter 0001101111001 0,4..5,7..10      ; 4540
.shutter 0001101111011 0,4..5,7..10,12   ; 4541
.shutter 0001101111101 0,4..5,7..11      ; 4542
.shutter 0001101111111 0,4..5,7..12      ; 4543
.shutter 0001110000001 0,4..6            ; 4544
.shutter 0001110000011 0,4..6,12         ; 4545
.shutter 0001110000101 0,4..6,11         ; 4546
.shutter 0001110000111 0,4..6,11..12     ; 4547
.shutter 0001110001001 0,4..6,10         ; 4548
.shutter 0001110001011 0,4..6,10,12      ; 4549
.shutter 0001110001101 0,4..6,10..11     ; 4550
.shutter 0001110001111 0,4..6,10..12     ; 4551
.shutter 0001110010001 0,4..6,9          ; 4552
.shutter 0001110010011 0,4..6,9,12       ; 4553
.shutter 0001110010101 0,4..6,9,11       ; 4554
.shutter 0001110010111 0,4..6,9,11..12   ; 4555
.shutter 0001110011001 0,4..6,9..10      ; 4556
.shutter 0001110011011 0,4..6,9..10,12   ; 4557
.shutter 0001110011101 0,4..6,9..11      ; 4558
.shutter 0001110011111 0,4..6,9..12      ; 4559
.shutter 0001110100001 0,4..6,8          ; 4560
.shutter 0001110100011 0,4..6,8,12       ; 4561
.shutter 0001110100101 0,4..6,8,11       ; 4562
.shutter 0001110100111 0,4..6,8,11..12   ; 4563
.shutter 0001110101001 0,4..6,8,10       ; 4564
.shutter 0001110101011 0,4..6,8..12/2    ; 4565
.shutter 0001110101101 0,4..6,8,10..11   ; 4566
.shutter 0001110101111 0,4..6,8,10..12   ; 4567
.shutter 0001110110001 0,4..6,8..9       ; 4568
.shutter 0001110110011 0,4..6,8..9,12    ; 4569
.shutter 0001110110101 0,4..6,8..9,11    ; 4570
.shutter 0001110110111 0,4..6,8..9,11..12 ; 4571
.shutter 0001110111001 0,4..6,8..10      ; 4572
.shutter 0001110111011 0,4..6,8..10,12   ; 4573
.shutter 0001110111101 0,4..6,8..11      ; 4574
.shutter 0001110111111 0,4..6,8..12      ; 4575
.shutter 0001111000001 0,4..7            ; 4576
.shutter 0001111000011 0,4..7,12         ; 4577
.shutter 0001111000101 0,4..7,11         ; 4578
.shutter 0001111000111 0,4..7,11..12     ; 4579
.shutter 0001111001001 0,4..7,10         ; 4580
.shutter 0001111001011 0,4..7,10,12      ; 4581
.shutter 0001111001101 0,4..7,10..11     ; 4582
.shutter 0001111001111 0,4..7,10..12     ; 4583
.shutter 0001111010001 0,4..7,9          ; 4584
.shutter 0001111010011 0,4..7,9,12       ; 4585
.shutter 0001111010101 0,4..7,9,11       ; 4586
.shutter 0001111010111 0,4..7,9,11..12   ; 4587
.shutter 0001111011001 0,4..7,9..10      ; 4588
.shutter 0001111011011 0,4..7,9..10,12   ; 4589
.shutter 0001111011101 0,4..7,9..11      ; 4590
.shutter 0001111011111 0,4..7,9..12      ; 4591
.shutter 0001111100001 0,4..8            ; 4592
.shutter 0001111100011 0,4..8,12         ; 4593
.shutter 0001111100101 0,4..8,11         ; 4594
.shutter 0001111100111 0,4..8,11..12     ; 4595
.shutter 0001111101001 0,4..8,10         ; 4596
.shutter 0001111101011 0,4..8,10,12      ; 4597
.shutter 0001111101101 0,4..8,10..11     ; 4598
.shutter 0001111101111 0,4..8,10..12     ; 4599
.shutter 0001111110001 0,4..9            ; 4600
.shutter 0001111110011 0,4..9,12         ; 4601
.shutter 0001111110101 0,4..9,11         ; 4602
.shutter 0001111110111 0,4..9,11..12     ; 4603
.shutter 0001111111001 0,4..10           ; 4604
.shutter 0001111111011 0,4..10,12        ; 4605
.shutter 0001111111101 0,4..11           ; 4606
.shutter 0001111111111 0,4..12           ; 4607
.shutter 0010000000001 0,3               ; 4608
.shutter 0010000000011 0,3,12            ; 4609
.shutter 0010000000101 0,3,11            ; 4610
.shutter 0010000000111 0,3,11..12        ; 4611
.shutter 0010000001001 0,3,10            ; 4612
.shutter 0010000001011 0,3,10,12         ; 4613
.shutter 0010000001101 0,3,10..11        ; 4614
.shutter 0010000001111 0,3,10..12        ; 4615
.shutter 0010000010001 0,3,9             ; 4616
.shutter 0010000010011 0,3,9,12          ; 4617
.shutter 0010000010101 0,3,9,11          ; 4618
.shutter 0010000010111 0,3,9,11..12      ; 4619
.shutter 0010000011001 0,3,9..10         ; 4620
.shutter 0010000011011 0,3,9..10,12      ; 4621
.shutter 0010000011101 0,3,9..11         ; 4622
.shutter 0010000011111 0,3,9..12         ; 4623
.shutter 0010000100001 0,3,8             ; 4624
.shutter 0010000100011 0,3,8,12          ; 4625
.shutter 0010000100101 0,3,8,11          ; 4626
.shutter 0010000100111 0,3,8,11..12      ; 4627
.shutter 0010000101001 0,3,8,10          ; 4628
.shutter 0010000101011 0,3,8..12/2       ; 4629
.shutter 0010000101101 0,3,8,10..11      ; 4630
.shutter 0010000101111 0,3,8,10..12      ; 4631
.shutter 0010000110001 0,3,8..9          ; 4632
.shutter 0010000110011 0,3,8..9,12       ; 4633
.shutter 0010000110101 0,3,8..9,11       ; 4634
.shutter 0010000110111 0,3,8..9,11..12   ; 4635
.shutter 0010000111001 0,3,8..10         ; 4636
.shutter 0010000111011 0,3,8..10,12      ; 4637
.shutter 0010000111101 0,3,8..11         ; 4638
.shutter 0010000111111 0,3,8..12         ; 4639
.shutter 0010001000001 0,3,7             ; 4640
.shutter 0010001000011 0,3,7,12          ; 4641
.shutter 0010001000101 0,3,7,11          ; 4642
.shutter 0010001000111 0,3,7,11..12      ; 4643
.shutter 0010001001001 0,3,7,10          ; 4644
.shutter 0010001001011 0,3,7,10,12       ; 4645
.shutter 0010001001101 0,3,7,10..11      ; 4646
.shutter 0010001001111 0,3,7,10..12      ; 4647
.shutter 0010001010001 0,3,7,9           ; 4648
.shutter 0010001010011 0,3,7,9,12        ; 4649
.shutter 0010001010101 0,3,7..11/2       ; 4650
.shutter 0010001010111 0,3,7..11/2,12    ; 4651
.shutter 0010001011001 0,3,7,9..10       ; 4652
.shutter 0010001011011 0,3,7,9..10,12    ; 4653
.shutter 0010001011101 0,3,7,9..11       ; 4654
.shutter 0010001011111 0,3,7,9..12       ; 4655
.shutter 0010001100001 0,3,7..8          ; 4656
.shutter 0010001100011 0,3,7..8,12       ; 4657
.shutter 0010001100101 0,3,7..8,11       ; 4658
.shutter 0010001100111 0,3,7..8,11..12   ; 4659
.shutter 0010001101001 0,3,7..8,10       ; 4660
.shutter 0010001101011 0,3,7..8,10,12    ; 4661
.shutter 0010001101101 0,3,7..8,10..11   ; 4662
.shutter 0010001101111 0,3,7..8,10..12   ; 4663
.shutter 0010001110001 0,3,7..9          ; 4664
.shutter 0010001110011 0,3,7..9,12       ; 4665
.shutter 0010001110101 0,3,7..9,11       ; 4666
.shutter 0010001110111 0,3,7..9,11..12   ; 4667
.shutter 0010001111001 0,3,7..10         ; 4668
.shutter 0010001111011 0,3,7..10,12      ; 4669
.shutter 0010001111101 0,3,7..11         ; 4670
.shutter 0010001111111 0,3,7..12         ; 4671
.shutter 0010010000001 0,3,6             ; 4672
.shutter 0010010000011 0,3,6,12          ; 4673
.shutter 0010010000101 0,3,6,11          ; 4674
.shutter 0010010000111 0,3,6,11..12      ; 4675
.shutter 0010010001001 0,3,6,10          ; 4676
.shutter 0010010001011 0..6/3,10,12      ; 4677
.shutter 0010010001101 0,3,6,10..11      ; 4678
.shutter 0010010001111 0,3,6,10..12      ; 4679
.shutter 0010010010001 0,3,6,9           ; 4680
.shutter 0010010010011 0..12/3           ; 4681
.shutter 0010010010101 0..9/3,11         ; 4682
.shutter 0010010010111 0..9/3,11..12     ; 4683
.shutter 0010010011001 0,3,6,9..10       ; 4684
.shutter 0010010011011 0..9/3,10,12      ; 4685
.shutter 0010010011101 0,3,6,9..11       ; 4686
.shutter 0010010011111 0,3,6,9..12       ; 4687
.shutter 0010010100001 0,3,6,8           ; 4688
.shutter 0010010100011 0..6/3,8,12       ; 4689
.shutter 0010010100101 0..6/3,8,11       ; 4690
.shutter 0010010100111 0..6/3,8,11..12   ; 4691
.shutter 0010010101001 0..6/3,8,10       ; 4692
.shutter 0010010101011 0..6/3,8..12/2    ; 4693
.shutter 0010010101101 0..6/3,8,10..11   ; 4694
.shutter 0010010101111 0..6/3,8,10..12   ; 4695
.shutter 0010010110001 0,3,6,8..9        ; 4696
.shutter 0010010110011 0..6/3,8..9,12    ; 4697
.shutter 0010010110101 0..6/3,8..9,11    ; 4698
.shutter 0010010110111 0..6/3,8..9,11..12 ; 4699
.shutter 0010010111001 0,3,6,8..10       ; 4700
.shutter 0010010111011 0..6/3,8..10,12   ; 4701
.shutter 0010010111101 0,3,6,8..11       ; 4702
.shutter 0010010111111 0,3,6,8..12       ; 4703
.shutter 0010011000001 0,3,6..7          ; 4704
.shutter 0010011000011 0,3,6..7,12       ; 4705
.shutter 0010011000101 0,3,6..7,11       ; 4706
.shutter 0010011000111 0,3,6..7,11..12   ; 4707
.shutter 0010011001001 0,3,6..7,10       ; 4708
.shutter 0010011001011 0..6/3,7,10,12    ; 4709
.shutter 0010011001101 0,3,6..7,10..11   ; 4710
.shutter 0010011001111 0,3,6..7,10..12   ; 4711
.shutter 0010011010001 0,3,6..7,9        ; 4712
.shutter 0010011010011 0..6/3,7,9,12     ; 4713
.shutter 0010011010101 0..6/3,7..11/2    ; 4714
.shutter 0010011010111 0..6/3,7..11/2,12 ; 4715
.shutter 0010011011001 0,3,6..7,9..10    ; 4716
.shutter 0010011011011 0..6/3,7,9..10,12 ; 4717
.shutter 0010011011101 0,3,6..7,9..11    ; 4718
.shutter 0010011011111 0,3,6..7,9..12    ; 4719
.shutter 0010011100001 0,3,6..8          ; 4720
.shutter 0010011100011 0,3,6..8,12       ; 4721
.shutter 0010011100101 0,3,6..8,11       ; 4722
.shutter 0010011100111 0,3,6..8,11..12   ; 4723
.shutter 0010011101001 0,3,6..8,10       ; 4724
.shutter 0010011101011 0..6/3,7..8,10,12 ; 4725
.shutter 0010011101101 0,3,6..8,10..11   ; 4726
.shutter 0010011101111 0,3,6..8,10..12   ; 4727
.shutter 0010011110001 0,3,6..9          ; 4728
.shutter 0010011110011 0,3,6..9,12       ; 4729
.shutter 0010011110101 0,3,6..9,11       ; 4730
.shutter 0010011110111 0,3,6..9,11..12   ; 4731
.shutter 0010011111001 0,3,6..10         ; 4732
.shutter 0010011111011 0,3,6..10,12      ; 4733
.shutter 0010011111101 0,3,6..11         ; 4734
.shutter 0010011111111 0,3,6..12         ; 4735
.shutter 0010100000001 0,3,5             ; 4736
.shutter 0010100000011 0,3,5,12          ; 4737
.shutter 0010100000101 0,3,5,11          ; 4738
.shutter 0010100000111 0,3,5,11..12      ; 4739
.shutter 0010100001001 0,3,5,10          ; 4740
.shutter 0010100001011 0,3,5,10,12       ; 4741
.shutter 0010100001101 0,3,5,10..11      ; 4742
.shutter 0010100001111 0,3,5,10..12      ; 4743
.shutter 0010100010001 0,3,5,9           ; 4744
.shutter 0010100010011 0,3,5,9,12        ; 4745
.shutter 0010100010101 0,3,5,9,11        ; 4746
.shutter 0010100010111 0,3,5,9,11..12    ; 4747
.shutter 0010100011001 0,3,5,9..10       ; 4748
.shutter 0010100011011 0,3,5,9..10,12    ; 4749
.shutter 0010100011101 0,3,5,9..11       ; 4750
.shutter 0010100011111 0,3,5,9..12       ; 4751
.shutter 0010100100001 0,3,5,8           ; 4752
.shutter 0010100100011 0,3,5,8,12        ; 4753
.shutter 0010100100101 0,3,5..11/3       ; 4754
.shutter 0010100100111 0,3,5..11/3,12    ; 4755
.shutter 0010100101001 0,3,5,8,10        ; 4756
.shutter 0010100101011 0,3,5,8..12/2     ; 4757
.shutter 0010100101101 0,3,5,8,10..11    ; 4758
.shutter 0010100101111 0,3,5,8,10..12    ; 4759
.shutter 0010100110001 0,3,5,8..9        ; 4760
.shutter 0010100110011 0,3,5,8..9,12     ; 4761
.shutter 0010100110101 0,3,5,8..9,11     ; 4762
.shutter 0010100110111 0,3,5,8..9,11..12 ; 4763
.shutter 0010100111001 0,3,5,8..10       ; 4764
.shutter 0010100111011 0,3,5,8..10,12    ; 4765
.shutter 0010100111101 0,3,5,8..11       ; 4766
.shutter 0010100111111 0,3,5,8..12       ; 4767
.shutter 0010101000001 0,3,5,7           ; 4768
.shutter 0010101000011 0,3..7/2,12       ; 4769
.shutter 0010101000101 0,3..7/2,11       ; 4770
.shutter 0010101000111 0,3..7/2,11..12   ; 4771
.shutter 0010101001001 0,3..7/2,10       ; 4772
.shutter 0010101001011 0,3..7/2,10,12    ; 4773
.shutter 0010101001101 0,3..7/2,10..11   ; 4774
.shutter 0010101001111 0,3..7/2,10..12   ; 4775
.shutter 0010101010001 0,3..9/2          ; 4776
.shutter 0010101010011 0,3..9/2,12       ; 4777
.shutter 0010101010101 0,3..11/2         ; 4778
.shutter 0010101010111 0,3..11/2,12      ; 4779
.shutter 0010101011001 0,3..9/2,10       ; 4780
.shutter 0010101011011 0,3..9/2,10,12    ; 4781
.shutter 0010101011101 0,3..9/2,10..11   ; 4782
.shutter 0010101011111 0,3..9/2,10..12   ; 4783
.shutter 0010101100001 0,3,5,7..8        ; 4784
.shutter 0010101100011 0,3..7/2,8,12     ; 4785
.shutter 0010101100101 0,3..7/2,8,11     ; 4786
.shutter 0010101100111 0,3..7/2,8,11..12 ; 4787
.shutter 0010101101001 0,3..7/2,8,10     ; 4788
.shutter 0010101101011 0,3..7/2,8..12/2  ; 4789
.shutter 0010101101101 0,3..7/2,8,10..11 ; 4790
.shutter 0010101101111 0,3..7/2,8,10..12 ; 4791
.shutter 0010101110001 0,3,5,7..9        ; 4792
.shutter 0010101110011 0,3..7/2,8..9,12  ; 4793
.shutter 0010101110101 0,3..7/2,8..9,11  ; 4794
.shutter 0010101110111 0,3..7/2,8..9,11..12 ; 4795
.shutter 0010101111001 0,3,5,7..10       ; 4796
.shutter 0010101111011 0,3..7/2,8..10,12 ; 4797
.shutter 0010101111101 0,3,5,7..11       ; 4798
.shutter 0010101111111 0,3,5,7..12       ; 4799
.shutter 0010110000001 0,3,5..6          ; 4800
.shutter 0010110000011 0,3,5..6,12       ; 4801
.shutter 0010110000101 0,3,5..6,11       ; 4802
.shutter 0010110000111 0,3,5..6,11..12   ; 4803
.shutter 0010110001001 0,3,5..6,10       ; 4804
.shutter 0010110001011 0,3,5..6,10,12    ; 4805
.shutter 0010110001101 0,3,5..6,10..11   ; 4806
.shutter 0010110001111 0,3,5..6,10..12   ; 4807
.shutter 0010110010001 0,3,5..6,9        ; 4808
.shutter 0010110010011 0,3,5..6,9,12     ; 4809
.shutter 0010110010101 0,3,5..6,9,11     ; 4810
.shutter 0010110010111 0,3,5..6,9,11..12 ; 4811
.shutter 0010110011001 0,3,5..6,9..10    ; 4812
.shutter 0010110011011 0,3,5..6,9..10,12 ; 4813
.shutter 0010110011101 0,3,5..6,9..11    ; 4814
.shutter 0010110011111 0,3,5..6,9..12    ; 4815
.shutter 0010110100001 0,3,5..6,8        ; 4816
.shutter 0010110100011 0,3,5..6,8,12     ; 4817
.shutter 0010110100101 0,3,5..6,8,11     ; 4818
.shutter 0010110100111 0,3,5..6,8,11..12 ; 4819
.shutter 0010110101001 0,3,5..6,8,10     ; 4820
.shutter 0010110101011 0,3,5..6,8..12/2  ; 4821
.shutter 0010110101101 0,3,5..6,8,10..11 ; 4822
.shutter 0010110101111 0,3,5..6,8,10..12 ; 4823
.shutter 0010110110001 0,3,5..6,8..9     ; 4824
.shutter 0010110110011 0,3,5..6,8..9,12  ; 4825
.shutter 0010110110101 0,3,5..6,8..9,11  ; 4826
.shutter 0010110110111 0,3,5..6,8..9,11..12 ; 4827
.shutter 0010110111001 0,3,5..6,8..10    ; 4828
.shutter 0010110111011 0,3,5..6,8..10,12 ; 4829
.shutter 0010110111101 0,3,5..6,8..11    ; 4830
.shutter 0010110111111 0,3,5..6,8..12    ; 4831
.shutter 0010111000001 0,3,5..7          ; 4832
.shutter 0010111000011 0,3,5..7,12       ; 4833
.shutter 0010111000101 0,3,5..7,11       ; 4834
.shutter 0010111000111 0,3,5..7,11..12   ; 4835
.shutter 0010111001001 0,3,5..7,10       ; 4836
.shutter 0010111001011 0,3,5..7,10,12    ; 4837
.shutter 0010111001101 0,3,5..7,10..11   ; 4838
.shutter 0010111001111 0,3,5..7,10..12   ; 4839
.shutter 0010111010001 0,3,5..7,9        ; 4840
.shutter 0010111010011 0,3,5..7,9,12     ; 4841
.shutter 0010111010101 0,3,5..7,9,11     ; 4842
.shutter 0010111010111 0,3,5..7,9,11..12 ; 4843
.shutter 0010111011001 0,3,5..7,9..10    ; 4844
.shutter 0010111011011 0,3,5..7,9..10,12 ; 4845
.shutter 0010111011101 0,3,5..7,9..11    ; 4846
.shutter 0010111011111 0,3,5..7,9..12    ; 4847
.shutter 0010111100001 0,3,5..8          ; 4848
.shutter 0010111100011 0,3,5..8,12       ; 4849
.shutter 0010111100101 0,3,5..8,11       ; 4850
.shutter 0010111100111 0,3,5..8,11..12   ; 4851
.shutter 0010111101001 0,3,5..8,10       ; 4852
.shutter 0010111101011 0,3,5..8,10,12    ; 4853
.shutter 0010111101101 0,3,5..8,10..11   ; 4854
.shutter 0010111101111 0,3,5..8,10..12   ; 4855
.shutter 0010111110001 0,3,5..9          ; 4856
.shutter 0010111110011 0,3,5..9,12       ; 4857
.shutter 0010111110101 0,3,5..9,11       ; 4858
.shutter 0010111110111 0,3,5..9,11..12   ; 4859
.shutter 0010111111001 0,3,5..10         ; 4860
.shutter 0010111111011 0,3,5..10,12      ; 4861
.shutter 0010111111101 0,3,5..11         ; 4862
.shutter 0010111111111 0,3,5..12         ; 4863
.shutter 0011000000001 0,3..4            ; 4864
.shutter 0011000000011 0,3..4,12         ; 4865
.shutter 0011000000101 0,3..4,11         ; 4866
.shutter 0011000000111 0,3..4,11..12     ; 4867
.shutter 0011000001001 0,3..4,10         ; 4868
.shutter 0011000001011 0,3..4,10,12      ; 4869
.shutter 0011000001101 0,3..4,10..11     ; 4870
.shutter 0011000001111 0,3..4,10..12     ; 4871
.shutter 0011000010001 0,3..4,9          ; 4872
.shutter 0011000010011 0,3..4,9,12       ; 4873
.shutter 0011000010101 0,3..4,9,11       ; 4874
.shutter 0011000010111 0,3..4,9,11..12   ; 4875
.shutter 0011000011001 0,3..4,9..10      ; 4876
.shutter 0011000011011 0,3..4,9..10,12   ; 4877
.shutter 0011000011101 0,3..4,9..11      ; 4878
.shutter 0011000011111 0,3..4,9..12      ; 4879
.shutter 0011000100001 0,3..4,8          ; 4880
.shutter 0011000100011 0,3..4,8,12       ; 4881
.shutter 0011000100101 0,3..4,8,11       ; 4882
.shutter 0011000100111 0,3..4,8,11..12   ; 4883
.shutter 0011000101001 0,3..4,8,10       ; 4884
.shutter 0011000101011 0,3..4,8..12/2    ; 4885
.shutter 0011000101101 0,3..4,8,10..11   ; 4886
.shutter 0011000101111 0,3..4,8,10..12   ; 4887
.shutter 0011000110001 0,3..4,8..9       ; 4888
.shutter 0011000110011 0,3..4,8..9,12    ; 4889
.shutter 0011000110101 0,3..4,8..9,11    ; 4890
.shutter 0011000110111 0,3..4,8..9,11..12 ; 4891
.shutter 0011000111001 0,3..4,8..10      ; 4892
.shutter 0011000111011 0,3..4,8..10,12   ; 4893
.shutter 0011000111101 0,3..4,8..11      ; 4894
.shutter 0011000111111 0,3..4,8..12      ; 4895
.shutter 0011001000001 0,3..4,7          ; 4896
.shutter 0011001000011 0,3..4,7,12       ; 4897
.shutter 0011001000101 0,3..4,7,11       ; 4898
.shutter 0011001000111 0,3..4,7,11..12   ; 4899
.shutter 0011001001001 0,3..4,7,10       ; 4900
.shutter 0011001001011 0,3..4,7,10,12    ; 4901
.shutter 0011001001101 0,3..4,7,10..11   ; 4902
.shutter 0011001001111 0,3..4,7,10..12   ; 4903
.shutter 0011001010001 0,3..4,7,9        ; 4904
.shutter 0011001010011 0,3..4,7,9,12     ; 4905
.shutter 0011001010101 0,3..4,7..11/2    ; 4906
.shutter 0011001010111 0,3..4,7..11/2,12 ; 4907
.shutter 0011001011001 0,3..4,7,9..10    ; 4908
.shutter 0011001011011 0,3..4,7,9..10,12 ; 4909
.shutter 0011001011101 0,3..4,7,9..11    ; 4910
.shutter 0011001011111 0,3..4,7,9..12    ; 4911
.shutter 0011001100001 0,3..4,7..8       ; 4912
.shutter 0011001100011 0,3..4,7..8,12    ; 4913
.shutter 0011001100101 0,3..4,7..8,11    ; 4914
.shutter 0011001100111 0,3..4,7..8,11..12 ; 4915
.shutter 0011001101001 0,3..4,7..8,10    ; 4916
.shutter 0011001101011 0,3..4,7..8,10,12 ; 4917
.shutter 0011001101101 0,3..4,7..8,10..11 ; 4918
.shutter 0011001101111 0,3..4,7..8,10..12 ; 4919
.shutter 0011001110001 0,3..4,7..9       ; 4920
.shutter 0011001110011 0,3..4,7..9,12    ; 4921
.shutter 0011001110101 0,3..4,7..9,11    ; 4922
.shutter 0011001110111 0,3..4,7..9,11..12 ; 4923
.shutter 0011001111001 0,3..4,7..10      ; 4924
.shutter 0011001111011 0,3..4,7..10,12   ; 4925
.shutter 0011001111101 0,3..4,7..11      ; 4926
.shutter 0011001111111 0,3..4,7..12      ; 4927
.shutter 0011010000001 0,3..4,6          ; 4928
.shutter 0011010000011 0,3..4,6,12       ; 4929
.shutter 0011010000101 0,3..4,6,11       ; 4930
.shutter 0011010000111 0,3..4,6,11..12   ; 4931
.shutter 0011010001001 0,3..4,6,10       ; 4932
.shutter 0011010001011 0,3..4,6,10,12    ; 4933
.shutter 0011010001101 0,3..4,6,10..11   ; 4934
.shutter 0011010001111 0,3..4,6,10..12   ; 4935
.shutter 0011010010001 0,3..4,6,9        ; 4936
.shutter 0011010010011 0,3..4,6..12/3    ; 4937
.shutter 0011010010101 0,3..4,6,9,11     ; 4938
.shutter 0011010010111 0,3..4,6,9,11..12 ; 4939
.shutter 0011010011001 0,3..4,6,9..10    ; 4940
.shutter 0011010011011 0,3..4,6,9..10,12 ; 4941
.shutter 0011010011101 0,3..4,6,9..11    ; 4942
.shutter 0011010011111 0,3..4,6,9..12    ; 4943
.shutter 0011010100001 0,3..4,6,8        ; 4944
.shutter 0011010100011 0,3..4,6,8,12     ; 4945
.shutter 0011010100101 0,3..4,6,8,11     ; 4946
.shutter 0011010100111 0,3..4,6,8,11..12 ; 4947
.shutter 0011010101001 0,3..4,6..10/2    ; 4948
.shutter 0011010101011 0,3..4,6..12/2    ; 4949
.shutter 0011010101101 0,3..4,6..10/2,11 ; 4950
.shutter 0011010101111 x591d             ; 4951
.shutter 0011010110001 0,3..4,6,8..9     ; 4952
.shutter 0011010110011 0,3..4,6,8..9,12  ; 4953
.shutter 0011010110101 0,3..4,6,8..9,11  ; 4954
.shutter 0011010110111 0,3..4,6,8..9,11..12 ; 4955
.shutter 0011010111001 0,3..4,6,8..10    ; 4956
.shutter 0011010111011 0,3..4,6,8..10,12 ; 4957
.shutter 0011010111101 0,3..4,6,8..11    ; 4958
.shutter 0011010111111 0,3..4,6,8..12    ; 4959
.shutter 0011011000001 0,3..4,6..7       ; 4960
.shutter 0011011000011 0,3..4,6..7,12    ; 4961
.shutter 0011011000101 0,3..4,6..7,11    ; 4962
.shutter 0011011000111 0,3..4,6..7,11..12 ; 4963
.shutter 0011011001001 0,3..4,6..7,10    ; 4964
.shutter 0011011001011 0,3..4,6..7,10,12 ; 4965
.shutter 0011011001101 0,3..4,6..7,10..11 ; 4966
.shutter 0011011001111 0,3..4,6..7,10..12 ; 4967
.shutter 0011011010001 0,3..4,6..7,9     ; 4968
.shutter 0011011010011 0,3..4,6..7,9,12  ; 4969
.shutter 0011011010101 0,3..4,6..7,9,11  ; 4970
.shutter 0011011010111 0,3..4,6..7,9,11..12 ; 4971
.shutter 0011011011001 0,3..4,6..7,9..10 ; 4972
.shutter 0011011011011 0,3..4,6..7,9..10,12 ; 4973
.shutter 0011011011101 0,3..4,6..7,9..11 ; 4974
.shutter 0011011011111 0,3..4,6..7,9..12 ; 4975
.shutter 0011011100001 0,3..4,6..8       ; 4976
.shutter 0011011100011 0,3..4,6..8,12    ; 4977
.shutter 0011011100101 0,3..4,6..8,11    ; 4978
.shutter 0011011100111 0,3..4,6..8,11..12 ; 4979
.shutter 0011011101001 0,3..4,6..8,10    ; 4980
.shutter 0011011101011 0,3..4,6..8,10,12 ; 4981
.shutter 0011011101101 0,3..4,6..8,10..11 ; 4982
.shutter 0011011101111 0,3..4,6..8,10..12 ; 4983
.shutter 0011011110001 0,3..4,6..9       ; 4984
.shutter 0011011110011 0,3..4,6..9,12    ; 4985
.shutter 0011011110101 0,3..4,6..9,11    ; 4986
.shutter 0011011110111 0,3..4,6..9,11..12 ; 4987
.shutter 0011011111001 0,3..4,6..10      ; 4988
.shutter 0011011111011 0,3..4,6..10,12   ; 4989
.shutter 0011011111101 0,3..4,6..11      ; 4990
.shutter 0011011111111 0,3..4,6..12      ; 4991
.shutter 0011100000001 0,3..5            ; 4992
.shutter 0011100000011 0,3..5,12         ; 4993
.shutter 0011100000101 0,3..5,11         ; 4994
.shutter 0011100000111 0,3..5,11..12     ; 4995
.shutter 0011100001001 0,3..5,10         ; 4996
.shutter 0011100001011 0,3..5,10,12      ; 4997
.shutter 0011100001101 0,3..5,10..11     ; 4998
.shutter 0011100001111 0,3..5,10..12     ; 4999
.shutter 0011100010001 0,3..5,9          ; 5000
.shutter 0011100010011 0,3..5,9,12       ; 5001
.shutter 0011100010101 0,3..5,9,11       ; 5002
.shutter 0011100010111 0,3..5,9,11..12   ; 5003
.shutter 0011100011001 0,3..5,9..10      ; 5004
.shutter 0011100011011 0,3..5,9..10,12   ; 5005
.shutter 0011100011101 0,3..5,9..11      ; 5006
.shutter 0011100011111 0,3..5,9..12      ; 5007
.shutter 0011100100001 0,3..5,8          ; 5008
.shutter 0011100100011 0,3..5,8,12       ; 5009
.shutter 0011100100101 0,3..5,8,11       ; 5010
.shutter 0011100100111 0,3..5,8,11..12   ; 5011
.shutter 0011100101001 0,3..5,8,10       ; 5012
.shutter 0011100101011 0,3..5,8..12/2    ; 5013
.shutter 0011100101101 0,3..5,8,10..11   ; 5014
.shutter 0011100101111 0,3..5,8,10..12   ; 5015
.shutter 0011100110001 0,3..5,8..9       ; 5016
.shutter 0011100110011 0,3..5,8..9,12    ; 5017
.shutter 0011100110101 0,3..5,8..9,11    ; 5018
.shutter 0011100110111 0,3..5,8..9,11..12 ; 5019
.shutter 0011100111001 0,3..5,8..10      ; 5020
.shutter 0011100111011 0,3..5,8..10,12   ; 5021
.shutter 0011100111101 0,3..5,8..11      ; 5022
.shutter 0011100111111 0,3..5,8..12      ; 5023
.shutter 0011101000001 0,3..5,7          ; 5024
.shutter 0011101000011 0,3..5,7,12       ; 5025
.shutter 0011101000101 0,3..5,7,11       ; 5026
.shutter 0011101000111 0,3..5,7,11..12   ; 5027
.shutter 0011101001001 0,3..5,7,10       ; 5028
.shutter 0011101001011 0,3..5,7,10,12    ; 5029
.shutter 0011101001101 0,3..5,7,10..11   ; 5030
.shutter 0011101001111 0,3..5,7,10..12   ; 5031
.shutter 0011101010001 0,3..5,7,9        ; 5032
.shutter 0011101010011 0,3..5,7,9,12     ; 5033
.shutter 0011101010101 0,3..5,7..11/2    ; 5034
.shutter 0011101010111 0,3..5,7..11/2,12 ; 5035
.shutter 0011101011001 0,3..5,7,9..10    ; 5036
.shutter 0011101011011 0,3..5,7,9..10,12 ; 5037
.shutter 0011101011101 0,3..5,7,9..11    ; 5038
.shutter 0011101011111 0,3..5,7,9..12    ; 5039
.shutter 0011101100001 0,3..5,7..8       ; 5040
.shutter 0011101100011 0,3..5,7..8,12    ; 5041
.shutter 0011101100101 0,3..5,7..8,11    ; 5042
.shutter 0011101100111 0,3..5,7..8,11..12 ; 5043
.shutter 0011101101001 0,3..5,7..8,10    ; 5044
.shutter 0011101101011 0,3..5,7..8,10,12 ; 5045
.shutter 0011101101101 0,3..5,7..8,10..11 ; 5046
.shutter 0011101101111 0,3..5,7..8,10..12 ; 5047
.shutter 0011101110001 0,3..5,7..9       ; 5048
.shutter 0011101110011 0,3..5,7..9,12    ; 5049
.shutter 0011101110101 0,3..5,7..9,11    ; 5050
.shutter 0011101110111 0,3..5,7..9,11..12 ; 5051
.shutter 0011101111001 0,3..5,7..10      ; 5052
.shutter 0011101111011 0,3..5,7..10,12   ; 5053
.shutter 0011101111101 0,3..5,7..11      ; 5054
.shutter 0011101111111 0,3..5,7..12      ; 5055
.shutter 0011110000001 0,3..6            ; 5056
.shutter 0011110000011 0,3..6,12         ; 5057
.shutter 0011110000101 0,3..6,11         ; 5058
.shutter 0011110000111 0,3..6,11..12     ; 5059
.shutter 0011110001001 0,3..6,10         ; 5060
.shutter 0011110001011 0,3..6,10,12      ; 5061
.shutter 0011110001101 0,3..6,10..11     ; 5062
.shutter 0011110001111 0,3..6,10..12     ; 5063
.shutter 0011110010001 0,3..6,9          ; 5064
.shutter 0011110010011 0,3..6,9,12       ; 5065
.shutter 0011110010101 0,3..6,9,11       ; 5066
.shutter 0011110010111 0,3..6,9,11..12   ; 5067
.shutter 0011110011001 0,3..6,9..10      ; 5068
.shutter 0011110011011 0,3..6,9..10,12   ; 5069
.shutter 0011110011101 0,3..6,9..11      ; 5070
.shutter 0011110011111 0,3..6,9..12      ; 5071
.shutter 0011110100001 0,3..6,8          ; 5072
.shutter 0011110100011 0,3..6,8,12       ; 5073
.shutter 0011110100101 0,3..6,8,11       ; 5074
.shutter 0011110100111 0,3..6,8,11..12   ; 5075
.shutter 0011110101001 0,3..6,8,10       ; 5076
.shutter 0011110101011 0,3..6,8..12/2    ; 5077
.shutter 0011110101101 0,3..6,8,10..11   ; 5078
.shutter 0011110101111 0,3..6,8,10..12   ; 5079
.shutter 0011110110001 0,3..6,8..9       ; 5080
.shutter 0011110110011 0,3..6,8..9,12    ; 5081
.shutter 0011110110101 0,3..6,8..9,11    ; 5082
.shutter 0011110110111 0,3..6,8..9,11..12 ; 5083
.shutter 0011110111001 0,3..6,8..10      ; 5084
.shutter 0011110111011 0,3..6,8..10,12   ; 5085
.shutter 0011110111101 0,3..6,8..11      ; 5086
.shutter 0011110111111 0,3..6,8..12      ; 5087
.shutter 0011111000001 0,3..7            ; 5088
.shutter 0011111000011 0,3..7,12         ; 5089
.shutter 0011111000101 0,3..7,11         ; 5090
.shutter 0011111000111 0,3..7,11..12     ; 5091
.shutter 0011111001001 0,3..7,10         ; 5092
.shutter 0011111001011 0,3..7,10,12      ; 5093
.shutter 0011111001101 0,3..7,10..11     ; 5094
.shutter 0011111001111 0,3..7,10..12     ; 5095
.shutter 0011111010001 0,3..7,9          ; 5096
.shutter 0011111010011 0,3..7,9,12       ; 5097
.shutter 0011111010101 0,3..7,9,11       ; 5098
.shutter 0011111010111 0,3..7,9,11..12   ; 5099
.shutter 0011111011001 0,3..7,9..10      ; 5100
.shutter 0011111011011 0,3..7,9..10,12   ; 5101
.shutter 0011111011101 0,3..7,9..11      ; 5102
.shutter 0011111011111 0,3..7,9..12      ; 5103
.shutter 0011111100001 0,3..8            ; 5104
.shutter 0011111100011 0,3..8,12         ; 5105
.shutter 0011111100101 0,3..8,11         ; 5106
.shutter 0011111100111 0,3..8,11..12     ; 5107
.shutter 0011111101001 0,3..8,10         ; 5108
.shutter 0011111101011 0,3..8,10,12      ; 5109
.shutter 0011111101101 0,3..8,10..11     ; 5110
.shutter 0011111101111 0,3..8,10..12     ; 5111
.shutter 0011111110001 0,3..9            ; 5112
.shutter 0011111110011 0,3..9,12         ; 5113
.shutter 0011111110101 0,3..9,11         ; 5114
.shutter 0011111110111 0,3..9,11..12     ; 5115
.shutter 0011111111001 0,3..10           ; 5116
.shutter 0011111111011 0,3..10,12        ; 5117
.shutter 0011111111101 0,3..11           ; 5118
.shutter 0011111111111 0,3..12           ; 5119
.shutter 0100000000001 0,2               ; 5120
.shutter 0100000000011 0,2,12            ; 5121
.shutter 0100000000101 0,2,11            ; 5122
.shutter 0100000000111 0,2,11..12        ; 5123
.shutter 0100000001001 0,2,10            ; 5124
.shutter 0100000001011 0,2,10,12         ; 5125
.shutter 0100000001101 0,2,10..11        ; 5126
.shutter 0100000001111 0,2,10..12        ; 5127
.shutter 0100000010001 0,2,9             ; 5128
.shutter 0100000010011 0,2,9,12          ; 5129
.shutter 0100000010101 0,2,9,11          ; 5130
.shutter 0100000010111 0,2,9,11..12      ; 5131
.shutter 0100000011001 0,2,9..10         ; 5132
.shutter 0100000011011 0,2,9..10,12      ; 5133
.shutter 0100000011101 0,2,9..11         ; 5134
.shutter 0100000011111 0,2,9..12         ; 5135
.shutter 0100000100001 0,2,8             ; 5136
.shutter 0100000100011 0,2,8,12          ; 5137
.shutter 0100000100101 0,2,8,11          ; 5138
.shutter 0100000100111 0,2,8,11..12      ; 5139
.shutter 0100000101001 0,2,8,10          ; 5140
.shutter 0100000101011 0,2,8..12/2       ; 5141
.shutter 0100000101101 0,2,8,10..11      ; 5142
.shutter 0100000101111 0,2,8,10..12      ; 5143
.shutter 0100000110001 0,2,8..9          ; 5144
.shutter 0100000110011 0,2,8..9,12       ; 5145
.shutter 0100000110101 0,2,8..9,11       ; 5146
.shutter 0100000110111 0,2,8..9,11..12   ; 5147
.shutter 0100000111001 0,2,8..10         ; 5148
.shutter 0100000111011 0,2,8..10,12      ; 5149
.shutter 0100000111101 0,2,8..11         ; 5150
.shutter 0100000111111 0,2,8..12         ; 5151
.shutter 0100001000001 0,2,7             ; 5152
.shutter 0100001000011 0,2,7,12          ; 5153
.shutter 0100001000101 0,2,7,11          ; 5154
.shutter 0100001000111 0,2,7,11..12      ; 5155
.shutter 0100001001001 0,2,7,10          ; 5156
.shutter 0100001001011 0,2,7,10,12       ; 5157
.shutter 0100001001101 0,2,7,10..11      ; 5158
.shutter 0100001001111 0,2,7,10..12      ; 5159
.shutter 0100001010001 0,2,7,9           ; 5160
.shutter 0100001010011 0,2,7,9,12        ; 5161
.shutter 0100001010101 0,2,7..11/2       ; 5162
.shutter 0100001010111 0,2,7..11/2,12    ; 5163
.shutter 0100001011001 0,2,7,9..10       ; 5164
.shutter 0100001011011 0,2,7,9..10,12    ; 5165
.shutter 0100001011101 0,2,7,9..11       ; 5166
.shutter 0100001011111 0,2,7,9..12       ; 5167
.shutter 0100001100001 0,2,7..8          ; 5168
.shutter 0100001100011 0,2,7..8,12       ; 5169
.shutter 0100001100101 0,2,7..8,11       ; 5170
.shutter 0100001100111 0,2,7..8,11..12   ; 5171
.shutter 0100001101001 0,2,7..8,10       ; 5172
.shutter 0100001101011 0,2,7..8,10,12    ; 5173
.shutter 0100001101101 0,2,7..8,10..11   ; 5174
.shutter 0100001101111 0,2,7..8,10..12   ; 5175
.shutter 0100001110001 0,2,7..9          ; 5176
.shutter 0100001110011 0,2,7..9,12       ; 5177
.shutter 0100001110101 0,2,7..9,11       ; 5178
.shutter 0100001110111 0,2,7..9,11..12   ; 5179
.shutter 0100001111001 0,2,7..10         ; 5180
.shutter 0100001111011 0,2,7..10,12      ; 5181
.shutter 0100001111101 0,2,7..11         ; 5182
.shutter 0100001111111 0,2,7..12         ; 5183
.shutter 0100010000001 0,2,6             ; 5184
.shutter 0100010000011 0,2,6,12          ; 5185
.shutter 0100010000101 0,2,6,11          ; 5186
.shutter 0100010000111 0,2,6,11..12      ; 5187
.shutter 0100010001001 0,2,6,10          ; 5188
.shutter 0100010001011 0,2..10/4,12      ; 5189
.shutter 0100010001101 0,2,6,10..11      ; 5190
.shutter 0100010001111 0,2,6,10..12      ; 5191
.shutter 0100010010001 0,2,6,9           ; 5192
.shutter 0100010010011 0,2,6..12/3       ; 5193
.shutter 0100010010101 0,2,6,9,11        ; 5194
.shutter 0100010010111 0,2,6,9,11..12    ; 5195
.shutter 0100010011001 0,2,6,9..10       ; 5196
.shutter 0100010011011 0,2,6,9..10,12    ; 5197
.shutter 0100010011101 0,2,6,9..11       ; 5198
.shutter 0100010011111 0,2,6,9..12       ; 5199
.shutter 0100010100001 0,2,6,8           ; 5200
.shutter 0100010100011 0,2,6,8,12        ; 5201
.shutter 0100010100101 0,2,6,8,11        ; 5202
.shutter 0100010100111 0,2,6,8,11..12    ; 5203
.shutter 0100010101001 0,2,6..10/2       ; 5204
.shutter 0100010101011 0,2,6..12/2       ; 5205
.shutter 0100010101101 0,2,6..10/2,11    ; 5206
.shutter 0100010101111 0,2,6..10/2,11..12 ; 5207
.shutter 0100010110001 0,2,6,8..9        ; 5208
.shutter 0100010110011 0,2,6,8..9,12     ; 5209
.shutter 0100010110101 0,2,6,8..9,11     ; 5210
.shutter 0100010110111 0,2,6,8..9,11..12 ; 5211
.shutter 0100010111001 0,2,6,8..10       ; 5212
.shutter 0100010111011 0,2,6,8..10,12    ; 5213
.shutter 0100010111101 0,2,6,8..11       ; 5214
.shutter 0100010111111 0,2,6,8..12       ; 5215
.shutter 0100011000001 0,2,6..7          ; 5216
.shutter 0100011000011 0,2,6..7,12       ; 5217
.shutter 0100011000101 0,2,6..7,11       ; 5218
.shutter 0100011000111 0,2,6..7,11..12   ; 5219
.shutter 0100011001001 0,2,6..7,10       ; 5220
.shutter 0100011001011 0,2,6..7,10,12    ; 5221
.shutter 0100011001101 0,2,6..7,10..11   ; 5222
.shutter 0100011001111 0,2,6..7,10..12   ; 5223
.shutter 0100011010001 0,2,6..7,9        ; 5224
.shutter 0100011010011 0,2,6..7,9,12     ; 5225
.shutter 0100011010101 0,2,6..7,9,11     ; 5226
.shutter 0100011010111 0,2,6..7,9,11..12 ; 5227
.shutter 0100011011001 0,2,6..7,9..10    ; 5228
.shutter 0100011011011 0,2,6..7,9..10,12 ; 5229
.shutter 0100011011101 0,2,6..7,9..11    ; 5230
.shutter 0100011011111 0,2,6..7,9..12    ; 5231
.shutter 0100011100001 0,2,6..8          ; 5232
.shutter 0100011100011 0,2,6..8,12       ; 5233
.shutter 0100011100101 0,2,6..8,11       ; 5234
.shutter 0100011100111 0,2,6..8,11..12   ; 5235
.shutter 0100011101001 0,2,6..8,10       ; 5236
.shutter 0100011101011 0,2,6..8,10,12    ; 5237
.shutter 0100011101101 0,2,6..8,10..11   ; 5238
.shutter 0100011101111 0,2,6..8,10..12   ; 5239
.shutter 0100011110001 0,2,6..9          ; 5240
.shutter 0100011110011 0,2,6..9,12       ; 5241
.shutter 0100011110101 0,2,6..9,11       ; 5242
.shutter 0100011110111 0,2,6..9,11..12   ; 5243
.shutter 0100011111001 0,2,6..10         ; 5244
.shutter 0100011111011 0,2,6..10,12      ; 5245
.shutter 0100011111101 0,2,6..11         ; 5246
.shutter 0100011111111 0,2,6..12         ; 5247
.shutter 0100100000001 0,2,5             ; 5248
.shutter 0100100000011 0,2,5,12          ; 5249
.shutter 0100100000101 0,2,5,11          ; 5250
.shutter 0100100000111 0,2,5,11..12      ; 5251
.shutter 0100100001001 0,2,5,10          ; 5252
.shutter 0100100001011 0,2,5,10,12       ; 5253
.shutter 0100100001101 0,2,5,10..11      ; 5254
.shutter 0100100001111 0,2,5,10..12      ; 5255
.shutter 0100100010001 0,2,5,9           ; 5256
.shutter 0100100010011 0,2,5,9,12        ; 5257
.shutter 0100100010101 0,2,5,9,11        ; 5258
.shutter 0100100010111 0,2,5,9,11..12    ; 5259
.shutter 0100100011001 0,2,5,9..10       ; 5260
.shutter 0100100011011 0,2,5,9..10,12    ; 5261
.shutter 0100100011101 0,2,5,9..11       ; 5262
.shutter 0100100011111 0,2,5,9..12       ; 5263
.shutter 0100100100001 0,2,5,8           ; 5264
.shutter 0100100100011 0,2..8/3,12       ; 5265
.shutter 0100100100101 0,2..11/3         ; 5266
.shutter 0100100100111 0,2..11/3,12      ; 5267
.shutter 0100100101001 0,2..8/3,10       ; 5268
.shutter 0100100101011 0,2..8/3,10,12    ; 5269
.shutter 0100100101101 0,2..8/3,10..11   ; 5270
.shutter 0100100101111 0,2..8/3,10..12   ; 5271
.shutter 0100100110001 0,2,5,8..9        ; 5272
.shutter 0100100110011 0,2..8/3,9,12     ; 5273
.shutter 0100100110101 0,2..8/3,9,11     ; 5274
.shutter 0100100110111 0,2..8/3,9,11..12 ; 5275
.shutter 0100100111001 0,2,5,8..10       ; 5276
.shutter 0100100111011 0,2..8/3,9..10,12 ; 5277
.shutter 0100100111101 0,2,5,8..11       ; 5278
.shutter 0100100111111 0,2,5,8..12       ; 5279
.shutter 0100101000001 0,2,5,7           ; 5280
.shutter 0100101000011 0,2,5,7,12        ; 5281
.shutter 0100101000101 0,2,5,7,11        ; 5282
.shutter 0100101000111 0,2,5,7,11..12    ; 5283
.shutter 0100101001001 0,2,5,7,10        ; 5284
.shutter 0100101001011 0,2,5,7,10,12     ; 5285
.shutter 0100101001101 0,2,5,7,10..11    ; 5286
.shutter 0100101001111 0,2,5,7,10..12    ; 5287
.shutter 0100101010001 0,2,5..9/2        ; 5288
.shutter 0100101010011 0,2,5..9/2,12     ; 5289
.shutter 0100101010101 0,2,5..11/2       ; 5290
.shutter 0100101010111 0,2,5..11/2,12    ; 5291
.shutter 0100101011001 0,2,5..9/2,10     ; 5292
.shutter 0100101011011 0,2,5..9/2,10,12  ; 5293
.shutter 0100101011101 0,2,5..9/2,10..11 ; 5294
.shutter 0100101011111 0,2,5..9/2,10..12 ; 5295
.shutter 0100101100001 0,2,5,7..8        ; 5296
.shutter 0100101100011 0,2,5,7..8,12     ; 5297
.shutter 0100101100101 0,2,5,7..8,11     ; 5298
.shutter 0100101100111 0,2,5,7..8,11..12 ; 5299
.shutter 0100101101001 0,2,5,7..8,10     ; 5300
.shutter 0100101101011 0,2,5,7..8,10,12  ; 5301
.shutter 0100101101101 0,2,5,7..8,10..11 ; 5302
.shutter 0100101101111 0,2,5,7..8,10..12 ; 5303
.shutter 0100101110001 0,2,5,7..9        ; 5304
.shutter 0100101110011 0,2,5,7..9,12     ; 5305
.shutter 0100101110101 0,2,5,7..9,11     ; 5306
.shutter 0100101110111 0,2,5,7..9,11..12 ; 5307
.shutter 0100101111001 0,2,5,7..10       ; 5308
.shutter 0100101111011 0,2,5,7..10,12    ; 5309
.shutter 0100101111101 0,2,5,7..11       ; 5310
.shutter 0100101111111 0,2,5,7..12       ; 5311
.shutter 0100110000001 0,2,5..6          ; 5312
.shutter 0100110000011 0,2,5..6,12       ; 5313
.shutter 0100110000101 0,2,5..6,11       ; 5314
.shutter 0100110000111 0,2,5..6,11..12   ; 5315
.shutter 0100110001001 0,2,5..6,10       ; 5316
.shutter 0100110001011 0,2,5..6,10,12    ; 5317
.shutter 0100110001101 0,2,5..6,10..11   ; 5318
.shutter 0100110001111 0,2,5..6,10..12   ; 5319
.shutter 0100110010001 0,2,5..6,9        ; 5320
.shutter 0100110010011 0,2,5..6,9,12     ; 5321
.shutter 0100110010101 0,2,5..6,9,11     ; 5322
.shutter 0100110010111 0,2,5..6,9,11..12 ; 5323
.shutter 0100110011001 0,2,5..6,9..10    ; 5324
.shutter 0100110011011 0,2,5..6,9..10,12 ; 5325
.shutter 0100110011101 0,2,5..6,9..11    ; 5326
.shutter 0100110011111 0,2,5..6,9..12    ; 5327
.shutter 0100110100001 0,2,5..6,8        ; 5328
.shutter 0100110100011 0,2,5..6,8,12     ; 5329
.shutter 0100110100101 0,2,5..6,8,11     ; 5330
.shutter 0100110100111 0,2,5..6,8,11..12 ; 5331
.shutter 0100110101001 0,2,5..6,8,10     ; 5332
.shutter 0100110101011 0,2,5..6,8..12/2  ; 5333
.shutter 0100110101101 0,2,5..6,8,10..11 ; 5334
.shutter 0100110101111 0,2,5..6,8,10..12 ; 5335
.shutter 0100110110001 0,2,5..6,8..9     ; 5336
.shutter 0100110110011 0,2,5..6,8..9,12  ; 5337
.shutter 0100110110101 0,2,5..6,8..9,11  ; 5338
.shutter 0100110110111 0,2,5..6,8..9,11..12 ; 5339
.shutter 0100110111001 0,2,5..6,8..10    ; 5340
.shutter 0100110111011 0,2,5..6,8..10,12 ; 5341
.shutter 0100110111101 0,2,5..6,8..11    ; 5342
.shutter 0100110111111 0,2,5..6,8..12    ; 5343
.shutter 0100111000001 0,2,5..7          ; 5344
.shutter 0100111000011 0,2,5..7,12       ; 5345
.shutter 0100111000101 0,2,5..7,11       ; 5346
.shutter 0100111000111 0,2,5..7,11..12   ; 5347
.shutter 0100111001001 0,2,5..7,10       ; 5348
.shutter 0100111001011 0,2,5..7,10,12    ; 5349
.shutter 0100111001101 0,2,5..7,10..11   ; 5350
.shutter 0100111001111 0,2,5..7,10..12   ; 5351
.shutter 0100111010001 0,2,5..7,9        ; 5352
.shutter 0100111010011 0,2,5..7,9,12     ; 5353
.shutter 0100111010101 0,2,5..7,9,11     ; 5354
.shutter 0100111010111 0,2,5..7,9,11..12 ; 5355
.shutter 0100111011001 0,2,5..7,9..10    ; 5356
.shutter 0100111011011 0,2,5..7,9..10,12 ; 5357
.shutter 0100111011101 0,2,5..7,9..11    ; 5358
.shutter 0100111011111 0,2,5..7,9..12    ; 5359
.shutter 0100111100001 0,2,5..8          ; 5360
.shutter 0100111100011 0,2,5..8,12       ; 5361
.shutter 0100111100101 0,2,5..8,11       ; 5362
.shutter 0100111100111 0,2,5..8,11..12   ; 5363
.shutter 0100111101001 0,2,5..8,10       ; 5364
.shutter 0100111101011 0,2,5..8,10,12    ; 5365
.shutter 0100111101101 0,2,5..8,10..11   ; 5366
.shutter 0100111101111 0,2,5..8,10..12   ; 5367
.shutter 0100111110001 0,2,5..9          ; 5368
.shutter 0100111110011 0,2,5..9,12       ; 5369
.shutter 0100111110101 0,2,5..9,11       ; 5370
.shutter 0100111110111 0,2,5..9,11..12   ; 5371
.shutter 0100111111001 0,2,5..10         ; 5372
.shutter 0100111111011 0,2,5..10,12      ; 5373
.shutter 0100111111101 0,2,5..11         ; 5374
.shutter 0100111111111 0,2,5..12         ; 5375
.shutter 0101000000001 0,2,4             ; 5376
.shutter 0101000000011 0,2,4,12          ; 5377
.shutter 0101000000101 0,2,4,11          ; 5378
.shutter 0101000000111 0,2,4,11..12      ; 5379
.shutter 0101000001001 0,2,4,10          ; 5380
.shutter 0101000001011 0..4/2,10,12      ; 5381
.shutter 0101000001101 0,2,4,10..11      ; 5382
.shutter 0101000001111 0,2,4,10..12      ; 5383
.shutter 0101000010001 0,2,4,9           ; 5384
.shutter 0101000010011 0..4/2,9,12       ; 5385
.shutter 0101000010101 0..4/2,9,11       ; 5386
.shutter 0101000010111 0..4/2,9,11..12   ; 5387
.shutter 0101000011001 0,2,4,9..10       ; 5388
.shutter 0101000011011 0..4/2,9..10,12   ; 5389
.shutter 0101000011101 0,2,4,9..11       ; 5390
.shutter 0101000011111 0,2,4,9..12       ; 5391
.shutter 0101000100001 0,2,4,8           ; 5392
.shutter 0101000100011 0..4/2,8,12       ; 5393
.shutter 0101000100101 0..4/2,8,11       ; 5394
.shutter 0101000100111 0..4/2,8,11..12   ; 5395
.shutter 0101000101001 0..4/2,8,10       ; 5396
.shutter 0101000101011 0..4/2,8..12/2    ; 5397
.shutter 0101000101101 0..4/2,8,10..11   ; 5398
.shutter 0101000101111 0..4/2,8,10..12   ; 5399
.shutter 0101000110001 0,2,4,8..9        ; 5400
.shutter 0101000110011 0..4/2,8..9,12    ; 5401
.shutter 0101000110101 0..4/2,8..9,11    ; 5402
.shutter 0101000110111 0..4/2,8..9,11..12 ; 5403
.shutter 0101000111001 0,2,4,8..10       ; 5404
.shutter 0101000111011 0..4/2,8..10,12   ; 5405
.shutter 0101000111101 0,2,4,8..11       ; 5406
.shutter 0101000111111 0,2,4,8..12       ; 5407
.shutter 0101001000001 0,2,4,7           ; 5408
.shutter 0101001000011 0..4/2,7,12       ; 5409
.shutter 0101001000101 0..4/2,7,11       ; 5410
.shutter 0101001000111 0..4/2,7,11..12   ; 5411
.shutter 0101001001001 0..4/2,7,10       ; 5412
.shutter 0101001001011 0..4/2,7,10,12    ; 5413
.shutter 0101001001101 0..4/2,7,10..11   ; 5414
.shutter 0101001001111 0..4/2,7,10..12   ; 5415
.shutter 0101001010001 0..4/2,7,9        ; 5416
.shutter 0101001010011 0..4/2,7,9,12     ; 5417
.shutter 0101001010101 0..4/2,7..11/2    ; 5418
.shutter 0101001010111 0..4/2,7..11/2,12 ; 5419
.shutter 0101001011001 0..4/2,7,9..10    ; 5420
.shutter 0101001011011 0..4/2,7,9..10,12 ; 5421
.shutter 0101001011101 0..4/2,7,9..11    ; 5422
.shutter 0101001011111 0..4/2,7,9..12    ; 5423
.shutter 0101001100001 0,2,4,7..8        ; 5424
.shutter 0101001100011 0..4/2,7..8,12    ; 5425
.shutter 0101001100101 0..4/2,7..8,11    ; 5426
.shutter 0101001100111 0..4/2,7..8,11..12 ; 5427
.shutter 0101001101001 0..4/2,7..8,10    ; 5428
.shutter 0101001101011 0..4/2,7..8,10,12 ; 5429
.shutter 0101001101101 0..4/2,7..8,10..11 ; 5430
.shutter 0101001101111 0..4/2,7..8,10..12 ; 5431
.shutter 0101001110001 0,2,4,7..9        ; 5432
.shutter 0101001110011 0..4/2,7..9,12    ; 5433
.shutter 0101001110101 0..4/2,7..9,11    ; 5434
.shutter 0101001110111 0..4/2,7..9,11..12 ; 5435
.shutter 0101001111001 0,2,4,7..10       ; 5436
.shutter 0101001111011 0..4/2,7..10,12   ; 5437
.shutter 0101001111101 0,2,4,7..11       ; 5438
.shutter 0101001111111 0,2,4,7..12       ; 5439
.shutter 0101010000001 0,2,4,6           ; 5440
.shutter 0101010000011 0..6/2,12         ; 5441
.shutter 0101010000101 0..6/2,11         ; 5442
.shutter 0101010000111 0..6/2,11..12     ; 5443
.shutter 0101010001001 0..6/2,10         ; 5444
.shutter 0101010001011 0..6/2,10,12      ; 5445
.shutter 0101010001101 0..6/2,10..11     ; 5446
.shutter 0101010001111 0..6/2,10..12     ; 5447
.shutter 0101010010001 0..6/2,9          ; 5448
.shutter 0101010010011 0..6/2,9,12       ; 5449
.shutter 0101010010101 0..6/2,9,11       ; 5450
.shutter 0101010010111 0..6/2,9,11..12   ; 5451
.shutter 0101010011001 0..6/2,9..10      ; 5452
.shutter 0101010011011 0..6/2,9..10,12   ; 5453
.shutter 0101010011101 0..6/2,9..11      ; 5454
.shutter 0101010011111 0..6/2,9..12      ; 5455
.shutter 0101010100001 0..8/2            ; 5456
.shutter 0101010100011 0..8/2,12         ; 5457
.shutter 0101010100101 0..8/2,11         ; 5458
.shutter 0101010100111 0..8/2,11..12     ; 5459
.shutter 0101010101001 0..10/2           ; 5460
.shutter 0101010101011 0..12/2           ; 5461
.shutter 0101010101101 0..10/2,11        ; 5462
.shutter 0101010101111 0..10/2,11..12    ; 5463
.shutter 0101010110001 0..8/2,9          ; 5464
.shutter 0101010110011 0..8/2,9,12       ; 5465
.shutter 0101010110101 0..8/2,9,11       ; 5466
.shutter 0101010110111 0..8/2,9,11..12   ; 5467
.shutter 0101010111001 0..8/2,9..10      ; 5468
.shutter 0101010111011 0..8/2,9..10,12   ; 5469
.shutter 0101010111101 0..8/2,9..11      ; 5470
.shutter 0101010111111 0..8/2,9..12      ; 5471
.shutter 0101011000001 0,2,4,6..7        ; 5472
.shutter 0101011000011 0..6/2,7,12       ; 5473
.shutter 0101011000101 0..6/2,7,11       ; 5474
.shutter 0101011000111 0..6/2,7,11..12   ; 5475
.shutter 0101011001001 0..6/2,7,10       ; 5476
.shutter 0101011001011 0..6/2,7,10,12    ; 5477
.shutter 0101011001101 0..6/2,7,10..11   ; 5478
.shutter 0101011001111 0..6/2,7,10..12   ; 5479
.shutter 0101011010001 0..6/2,7,9        ; 5480
.shutter 0101011010011 0..6/2,7,9,12     ; 5481
.shutter 0101011010101 0..6/2,7..11/2    ; 5482
.shutter 0101011010111 0..6/2,7..11/2,12 ; 5483
.shutter 0101011011001 0..6/2,7,9..10    ; 5484
.shutter 0101011011011 0..6/2,7,9..10,12 ; 5485
.shutter 0101011011101 0..6/2,7,9..11    ; 5486
.shutter 0101011011111 0..6/2,7,9..12    ; 5487
.shutter 0101011100001 0,2,4,6..8        ; 5488
.shutter 0101011100011 0..6/2,7..8,12    ; 5489
.shutter 0101011100101 0..6/2,7..8,11    ; 5490
.shutter 0101011100111 0..6/2,7..8,11..12 ; 5491
.shutter 0101011101001 0..6/2,7..8,10    ; 5492
.shutter 0101011101011 0..6/2,7..8,10,12 ; 5493
.shutter 0101011101101 0..6/2,7..8,10..11 ; 5494
.shutter 0101011101111 0..6/2,7..8,10..12 ; 5495
.shutter 0101011110001 0,2,4,6..9        ; 5496
.shutter 0101011110011 0..6/2,7..9,12    ; 5497
.shutter 0101011110101 0..6/2,7..9,11    ; 5498
.shutter 0101011110111 0..6/2,7..9,11..12 ; 5499
.shutter 0101011111001 0,2,4,6..10       ; 5500
.shutter 0101011111011 0..6/2,7..10,12   ; 5501
.shutter 0101011111101 0,2,4,6..11       ; 5502
.shutter 0101011111111 0,2,4,6..12       ; 5503
.shutter 0101100000001 0,2,4..5          ; 5504
.shutter 0101100000011 0,2,4..5,12       ; 5505
.shutter 0101100000101 0,2,4..5,11       ; 5506
.shutter 0101100000111 0,2,4..5,11..12   ; 5507
.shutter 0101100001001 0,2,4..5,10       ; 5508
.shutter 0101100001011 0..4/2,5,10,12    ; 5509
.shutter 0101100001101 0,2,4..5,10..11   ; 5510
.shutter 0101100001111 0,2,4..5,10..12   ; 5511
.shutter 0101100010001 0,2,4..5,9        ; 5512
.shutter 0101100010011 0..4/2,5,9,12     ; 5513
.shutter 0101100010101 0..4/2,5,9,11     ; 5514
.shutter 0101100010111 0..4/2,5,9,11..12 ; 5515
.shutter 0101100011001 0,2,4..5,9..10    ; 5516
.shutter 0101100011011 0..4/2,5,9..10,12 ; 5517
.shutter 0101100011101 0,2,4..5,9..11    ; 5518
.shutter 0101100011111 0,2,4..5,9..12    ; 5519
.shutter 0101100100001 0,2,4..5,8        ; 5520
.shutter 0101100100011 0..4/2,5,8,12     ; 5521
.shutter 0101100100101 0..4/2,5..11/3    ; 5522
.shutter 0101100100111 0..4/2,5..11/3,12 ; 5523
.shutter 0101100101001 0..4/2,5,8,10     ; 5524
.shutter 0101100101011 0..4/2,5,8..12/2  ; 5525
.shutter 0101100101101 0..4/2,5,8,10..11 ; 5526
.shutter 0101100101111 0..4/2,5,8,10..12 ; 5527
.shutter 0101100110001 0,2,4..5,8..9     ; 5528
.shutter 0101100110011 0..4/2,5,8..9,12  ; 5529
.shutter 0101100110101 0..4/2,5,8..9,11  ; 5530
.shutter 0101100110111 0..4/2,5,8..9,11..12 ; 5531
.shutter 0101100111001 0,2,4..5,8..10    ; 5532
.shutter 0101100111011 0..4/2,5,8..10,12 ; 5533
.shutter 0101100111101 0,2,4..5,8..11    ; 5534
.shutter 0101100111111 0,2,4..5,8..12    ; 5535
.shutter 0101101000001 0,2,4..5,7        ; 5536
.shutter 0101101000011 0..4/2,5,7,12     ; 5537
.shutter 0101101000101 0..4/2,5,7,11     ; 5538
.shutter 0101101000111 0..4/2,5,7,11..12 ; 5539
.shutter 0101101001001 0..4/2,5,7,10     ; 5540
.shutter 0101101001011 0..4/2,5,7,10,12  ; 5541
.shutter 0101101001101 0..4/2,5,7,10..11 ; 5542
.shutter 0101101001111 0..4/2,5,7,10..12 ; 5543
.shutter 0101101010001 0..4/2,5..9/2     ; 5544
.shutter 0101101010011 0..4/2,5..9/2,12  ; 5545
.shutter 0101101010101 0..4/2,5..11/2    ; 5546
.shutter 0101101010111 0..4/2,5..11/2,12 ; 5547
.shutter 0101101011001 0..4/2,5..9/2,10  ; 5548
.shutter 0101101011011 0..4/2,5..9/2,10,12 ; 5549
.shutter 0101101011101 0..4/2,5..9/2,10..11 ; 5550
.shutter 0101101011111 0..4/2,5..9/2,10..12 ; 5551
.shutter 0101101100001 0,2,4..5,7..8     ; 5552
.shutter 0101101100011 0..4/2,5,7..8,12  ; 5553
.shutter 0101101100101 0..4/2,5,7..8,11  ; 5554
.shutter 0101101100111 0..4/2,5,7..8,11..12 ; 5555
.shutter 0101101101001 0..4/2,5,7..8,10  ; 5556
.shutter 0101101101011 0..4/2,5,7..8,10,12 ; 5557
.shutter 0101101101101 0..4/2,5,7..8,10..11 ; 5558
.shutter 0101101101111 0..4/2,5,7..8,10..12 ; 5559
.shutter 0101101110001 0,2,4..5,7..9     ; 5560
.shutter 0101101110011 0..4/2,5,7..9,12  ; 5561
.shutter 0101101110101 0..4/2,5,7..9,11  ; 5562
.shutter 0101101110111 0..4/2,5,7..9,11..12 ; 5563
.shutter 0101101111001 0,2,4..5,7..10    ; 5564
.shutter 0101101111011 0..4/2,5,7..10,12 ; 5565
.shutter 0101101111101 0,2,4..5,7..11    ; 5566
.shutter 0101101111111 0,2,4..5,7..12    ; 5567
.shutter 0101110000001 0,2,4..6          ; 5568
.shutter 0101110000011 0,2,4..6,12       ; 5569
.shutter 0101110000101 0,2,4..6,11       ; 5570
.shutter 0101110000111 0,2,4..6,11..12   ; 5571
.shutter 0101110001001 0,2,4..6,10       ; 5572
.shutter 0101110001011 0..4/2,5..6,10,12 ; 5573
.shutter 0101110001101 0,2,4..6,10..11   ; 5574
.shutter 0101110001111 0,2,4..6,10..12   ; 5575
.shutter 0101110010001 0,2,4..6,9        ; 5576
.shutter 0101110010011 0..4/2,5..6,9,12  ; 5577
.shutter 0101110010101 0..4/2,5..6,9,11  ; 5578
.shutter 0101110010111 0..4/2,5..6,9,11..12 ; 5579
.shutter 0101110011001 0,2,4..6,9..10    ; 5580
.shutter 0101110011011 0..4/2,5..6,9..10,12 ; 5581
.shutter 0101110011101 0,2,4..6,9..11    ; 5582
.shutter 0101110011111 0,2,4..6,9..12    ; 5583
.shutter 0101110100001 0,2,4..6,8        ; 5584
.shutter 0101110100011 0..4/2,5..6,8,12  ; 5585
.shutter 0101110100101 0..4/2,5..6,8,11  ; 5586
.shutter 0101110100111 0..4/2,5..6,8,11..12 ; 5587
.shutter 0101110101001 0..4/2,5..6,8,10  ; 5588
.shutter 0101110101011 0..4/2,5..6,8..12/2 ; 5589
.shutter 0101110101101 0..4/2,5..6,8,10..11 ; 5590
.shutter 0101110101111 0..4/2,5..6,8,10..12 ; 5591
.shutter 0101110110001 0,2,4..6,8..9     ; 5592
.shutter 0101110110011 0..4/2,5..6,8..9,12 ; 5593
.shutter 0101110110101 0..4/2,5..6,8..9,11 ; 5594
.shutter 0101110110111 x751b             ; 5595
.shutter 0101110111001 0,2,4..6,8..10    ; 5596
.shutter 0101110111011 0..4/2,5..6,8..10,12 ; 5597
.shutter 0101110111101 0,2,4..6,8..11    ; 5598
.shutter 0101110111111 0,2,4..6,8..12    ; 5599
.shutter 0101111000001 0,2,4..7          ; 5600
.shutter 0101111000011 0,2,4..7,12       ; 5601
.shutter 0101111000101 0,2,4..7,11       ; 5602
.shutter 0101111000111 0,2,4..7,11..12   ; 5603
.shutter 0101111001001 0,2,4..7,10       ; 5604
.shutter 0101111001011 0..4/2,5..7,10,12 ; 5605
.shutter 0101111001101 0,2,4..7,10..11   ; 5606
.shutter 0101111001111 0,2,4..7,10..12   ; 5607
.shutter 0101111010001 0,2,4..7,9        ; 5608
.shutter 0101111010011 0..4/2,5..7,9,12  ; 5609
.shutter 0101111010101 0..4/2,5..7,9,11  ; 5610
.shutter 0101111010111 0..4/2,5..7,9,11..12 ; 5611
.shutter 0101111011001 0,2,4..7,9..10    ; 5612
.shutter 0101111011011 0..4/2,5..7,9..10,12 ; 5613
.shutter 0101111011101 0,2,4..7,9..11    ; 5614
.shutter 0101111011111 0,2,4..7,9..12    ; 5615
.shutter 0101111100001 0,2,4..8          ; 5616
.shutter 0101111100011 0,2,4..8,12       ; 5617
.shutter 0101111100101 0,2,4..8,11       ; 5618
.shutter 0101111100111 0,2,4..8,11..12   ; 5619
.shutter 0101111101001 0,2,4..8,10       ; 5620
.shutter 0101111101011 0..4/2,5..8,10,12 ; 5621
.shutter 0101111101101 0,2,4..8,10..11   ; 5622
.shutter 0101111101111 0,2,4..8,10..12   ; 5623
.shutter 0101111110001 0,2,4..9          ; 5624
.shutter 0101111110011 0,2,4..9,12       ; 5625
.shutter 0101111110101 0,2,4..9,11       ; 5626
.shutter 0101111110111 0,2,4..9,11..12   ; 5627
.shutter 0101111111001 0,2,4..10         ; 5628
.shutter 0101111111011 0,2,4..10,12      ; 5629
.shutter 0101111111101 0,2,4..11         ; 5630
.shutter 0101111111111 0,2,4..12         ; 5631
.shutter 0110000000001 0,2..3            ; 5632
.shutter 0110000000011 0,2..3,12         ; 5633
.shutter 0110000000101 0,2..3,11         ; 5634
.shutter 0110000000111 0,2..3,11..12     ; 5635
.shutter 0110000001001 0,2..3,10         ; 5636
.shutter 0110000001011 0,2..3,10,12      ; 5637
.shutter 0110000001101 0,2..3,10..11     ; 5638
.shutter 0110000001111 0,2..3,10..12     ; 5639
.shutter 0110000010001 0,2..3,9          ; 5640
.shutter 0110000010011 0,2..3,9,12       ; 5641
.shutter 0110000010101 0,2..3,9,11       ; 5642
.shutter 0110000010111 0,2..3,9,11..12   ; 5643
.shutter 0110000011001 0,2..3,9..10      ; 5644
.shutter 0110000011011 0,2..3,9..10,12   ; 5645
.shutter 0110000011101 0,2..3,9..11      ; 5646
.shutter 0110000011111 0,2..3,9..12      ; 5647
.shutter 0110000100001 0,2..3,8          ; 5648
.shutter 0110000100011 0,2..3,8,12       ; 5649
.shutter 0110000100101 0,2..3,8,11       ; 5650
.shutter 0110000100111 0,2..3,8,11..12   ; 5651
.shutter 0110000101001 0,2..3,8,10       ; 5652
.shutter 0110000101011 0,2..3,8..12/2    ; 5653
.shutter 0110000101101 0,2..3,8,10..11   ; 5654
.shutter 0110000101111 0,2..3,8,10..12   ; 5655
.shutter 0110000110001 0,2..3,8..9       ; 5656
.shutter 0110000110011 0,2..3,8..9,12    ; 5657
.shutter 0110000110101 0,2..3,8..9,11    ; 5658
.shutter 0110000110111 0,2..3,8..9,11..12 ; 5659
.shutter 0110000111001 0,2..3,8..10      ; 5660
.shutter 0110000111011 0,2..3,8..10,12   ; 5661
.shutter 0110000111101 0,2..3,8..11      ; 5662
.shutter 0110000111111 0,2..3,8..12      ; 5663
.shutter 0110001000001 0,2..3,7          ; 5664
.shutter 0110001000011 0,2..3,7,12       ; 5665
.shutter 0110001000101 0,2..3,7,11       ; 5666
.shutter 0110001000111 0,2..3,7,11..12   ; 5667
.shutter 0110001001001 0,2..3,7,10       ; 5668
.shutter 0110001001011 0,2..3,7,10,12    ; 5669
.shutter 0110001001101 0,2..3,7,10..11   ; 5670
.shutter 0110001001111 0,2..3,7,10..12   ; 5671
.shutter 0110001010001 0,2..3,7,9        ; 5672
.shutter 0110001010011 0,2..3,7,9,12     ; 5673
.shutter 0110001010101 0,2..3,7..11/2    ; 5674
.shutter 0110001010111 0,2..3,7..11/2,12 ; 5675
.shutter 0110001011001 0,2..3,7,9..10    ; 5676
.shutter 0110001011011 0,2..3,7,9..10,12 ; 5677
.shutter 0110001011101 0,2..3,7,9..11    ; 5678
.shutter 0110001011111 0,2..3,7,9..12    ; 5679
.shutter 0110001100001 0,2..3,7..8       ; 5680
.shutter 0110001100011 0,2..3,7..8,12    ; 5681
.shutter 0110001100101 0,2..3,7..8,11    ; 5682
.shutter 0110001100111 0,2..3,7..8,11..12 ; 5683
.shutter 0110001101001 0,2..3,7..8,10    ; 5684
.shutter 0110001101011 0,2..3,7..8,10,12 ; 5685
.shutter 0110001101101 0,2..3,7..8,10..11 ; 5686
.shutter 0110001101111 0,2..3,7..8,10..12 ; 5687
.shutter 0110001110001 0,2..3,7..9       ; 5688
.shutter 0110001110011 0,2..3,7..9,12    ; 5689
.shutter 0110001110101 0,2..3,7..9,11    ; 5690
.shutter 0110001110111 0,2..3,7..9,11..12 ; 5691
.shutter 0110001111001 0,2..3,7..10      ; 5692
.shutter 0110001111011 0,2..3,7..10,12   ; 5693
.shutter 0110001111101 0,2..3,7..11      ; 5694
.shutter 0110001111111 0,2..3,7..12      ; 5695
.shutter 0110010000001 0,2..3,6          ; 5696
.shutter 0110010000011 0,2..3,6,12       ; 5697
.shutter 0110010000101 0,2..3,6,11       ; 5698
.shutter 0110010000111 0,2..3,6,11..12   ; 5699
.shutter 0110010001001 0,2..3,6,10       ; 5700
.shutter 0110010001011 0,2..3,6,10,12    ; 5701
.shutter 0110010001101 0,2..3,6,10..11   ; 5702
.shutter 0110010001111 0,2..3,6,10..12   ; 5703
.shutter 0110010010001 0,2..3,6,9        ; 5704
.shutter 0110010010011 0,2..3,6..12/3    ; 5705
.shutter 0110010010101 0,2..3,6,9,11     ; 5706
.shutter 0110010010111 0,2..3,6,9,11..12 ; 5707
.shutter 0110010011001 0,2..3,6,9..10    ; 5708
.shutter 0110010011011 0,2..3,6,9..10,12 ; 5709
.shutter 0110010011101 0,2..3,6,9..11    ; 5710
.shutter 0110010011111 0,2..3,6,9..12    ; 5711
.shutter 0110010100001 0,2..3,6,8        ; 5712
.shutter 0110010100011 0,2..3,6,8,12     ; 5713
.shutter 0110010100101 0,2..3,6,8,11     ; 5714
.shutter 0110010100111 0,2..3,6,8,11..12 ; 5715
.shutter 0110010101001 0,2..3,6..10/2    ; 5716
.shutter 0110010101011 0,2..3,6..12/2    ; 5717
.shutter 0110010101101 0,2..3,6..10/2,11 ; 5718
.shutter 0110010101111 x4d1d             ; 5719
.shutter 0110010110001 0,2..3,6,8..9     ; 5720
.shutter 0110010110011 0,2..3,6,8..9,12  ; 5721
.shutter 0110010110101 0,2..3,6,8..9,11  ; 5722
.shutter 0110010110111 0,2..3,6,8..9,11..12 ; 5723
.shutter 0110010111001 0,2..3,6,8..10    ; 5724
.shutter 0110010111011 0,2..3,6,8..10,12 ; 5725
.shutter 0110010111101 0,2..3,6,8..11    ; 5726
.shutter 0110010111111 0,2..3,6,8..12    ; 5727
.shutter 0110011000001 0,2..3,6..7       ; 5728
.shutter 0110011000011 0,2..3,6..7,12    ; 5729
.shutter 0110011000101 0,2..3,6..7,11    ; 5730
.shutter 0110011000111 0,2..3,6..7,11..12 ; 5731
.shutter 0110011001001 0,2..3,6..7,10    ; 5732
.shutter 0110011001011 0,2..3,6..7,10,12 ; 5733
.shutter 0110011001101 0,2..3,6..7,10..11 ; 5734
.shutter 0110011001111 0,2..3,6..7,10..12 ; 5735
.shutter 0110011010001 0,2..3,6..7,9     ; 5736
.shutter 0110011010011 0,2..3,6..7,9,12  ; 5737
.shutter 0110011010101 0,2..3,6..7,9,11  ; 5738
.shutter 0110011010111 0,2..3,6..7,9,11..12 ; 5739
.shutter 0110011011001 0,2..3,6..7,9..10 ; 5740
.shutter 0110011011011 0,2..3,6..7,9..10,12 ; 5741
.shutter 0110011011101 0,2..3,6..7,9..11 ; 5742
.shutter 0110011011111 0,2..3,6..7,9..12 ; 5743
.shutter 0110011100001 0,2..3,6..8       ; 5744
.shutter 0110011100011 0,2..3,6..8,12    ; 5745
.shutter 0110011100101 0,2..3,6..8,11    ; 5746
.shutter 0110011100111 0,2..3,6..8,11..12 ; 5747
.shutter 0110011101001 0,2..3,6..8,10    ; 5748
.shutter 0110011101011 0,2..3,6..8,10,12 ; 5749
.shutter 0110011101101 0,2..3,6..8,10..11 ; 5750
.shutter 0110011101111 0,2..3,6..8,10..12 ; 5751
.shutter 0110011110001 0,2..3,6..9       ; 5752
.shutter 0110011110011 0,2..3,6..9,12    ; 5753
.shutter 0110011110101 0,2..3,6..9,11    ; 5754
.shutter 0110011110111 0,2..3,6..9,11..12 ; 5755
.shutter 0110011111001 0,2..3,6..10      ; 5756
.shutter 0110011111011 0,2..3,6..10,12   ; 5757
.shutter 0110011111101 0,2..3,6..11      ; 5758
.shutter 0110011111111 0,2..3,6..12      ; 5759
.shutter 0110100000001 0,2..3,5          ; 5760
.shutter 0110100000011 0,2..3,5,12       ; 5761
.shutter 0110100000101 0,2..3,5,11       ; 5762
.shutter 0110100000111 0,2..3,5,11..12   ; 5763
.shutter 0110100001001 0,2..3,5,10       ; 5764
.shutter 0110100001011 0,2..3,5,10,12    ; 5765
.shutter 0110100001101 0,2..3,5,10..11   ; 5766
.shutter 0110100001111 0,2..3,5,10..12   ; 5767
.shutter 0110100010001 0,2..3,5,9        ; 5768
.shutter 0110100010011 0,2..3,5,9,12     ; 5769
.shutter 0110100010101 0,2..3,5,9,11     ; 5770
.shutter 0110100010111 0,2..3,5,9,11..12 ; 5771
.shutter 0110100011001 0,2..3,5,9..10    ; 5772
.shutter 0110100011011 0,2..3,5,9..10,12 ; 5773
.shutter 0110100011101 0,2..3,5,9..11    ; 5774
.shutter 0110100011111 0,2..3,5,9..12    ; 5775
.shutter 0110100100001 0,2..3,5,8        ; 5776
.shutter 0110100100011 0,2..3,5,8,12     ; 5777
.shutter 0110100100101 0,2..3,5..11/3    ; 5778
.shutter 0110100100111 0,2..3,5..11/3,12 ; 5779
.shutter 0110100101001 0,2..3,5,8,10     ; 5780
.shutter 0110100101011 0,2..3,5,8..12/2  ; 5781
.shutter 0110100101101 0,2..3,5,8,10..11 ; 5782
.shutter 0110100101111 0,2..3,5,8,10..12 ; 5783
.shutter 0110100110001 0,2..3,5,8..9     ; 5784
.shutter 0110100110011 0,2..3,5,8..9,12  ; 5785
.shutter 0110100110101 0,2..3,5,8..9,11  ; 5786
.shutter 0110100110111 0,2..3,5,8..9,11..12 ; 5787
.shutter 0110100111001 0,2..3,5,8..10    ; 5788
.shutter 0110100111011 0,2..3,5,8..10,12 ; 5789
.shutter 0110100111101 0,2..3,5,8..11    ; 5790
.shutter 0110100111111 0,2..3,5,8..12    ; 5791
.shutter 0110101000001 0,2..3,5,7        ; 5792
.shutter 0110101000011 0,2..3,5,7,12     ; 5793
.shutter 0110101000101 0,2..3,5,7,11     ; 5794
.shutter 0110101000111 0,2..3,5,7,11..12 ; 5795
.shutter 0110101001001 0,2..3,5,7,10     ; 5796
.shutter 0110101001011 0,2..3,5,7,10,12  ; 5797
.shutter 0110101001101 0,2..3,5,7,10..11 ; 5798
.shutter 0110101001111 0,2..3,5,7,10..12 ; 5799
.shutter 0110101010001 0,2..3,5..9/2     ; 5800
.shutter 0110101010011 0,2..3,5..9/2,12  ; 5801
.shutter 0110101010101 0,2..3,5..11/2    ; 5802
.shutter 0110101010111 0,2..3,5..11/2,12 ; 5803
.shutter 0110101011001 0,2..3,5..9/2,10  ; 5804
.shutter 0110101011011 0,2..3,5..9/2,10,12 ; 5805
.shutter 0110101011101 0,2..3,5..9/2,10..11 ; 5806
.shutter 0110101011111 0,2..3,5..9/2,10..12 ; 5807
.shutter 0110101100001 0,2..3,5,7..8     ; 5808
.shutter 0110101100011 0,2..3,5,7..8,12  ; 5809
.shutter 0110101100101 0,2..3,5,7..8,11  ; 5810
.shutter 0110101100111 0,2..3,5,7..8,11..12 ; 5811
.shutter 0110101101001 0,2..3,5,7..8,10  ; 5812
.shutter 0110101101011 0,2..3,5,7..8,10,12 ; 5813
.shutter 0110101101101 0,2..3,5,7..8,10..11 ; 5814
.shutter 0110101101111 0,2..3,5,7..8,10..12 ; 5815
.shutter 0110101110001 0,2..3,5,7..9     ; 5816
.shutter 0110101110011 0,2..3,5,7..9,12  ; 5817
.shutter 0110101110101 0,2..3,5,7..9,11  ; 5818
.shutter 0110101110111 0,2..3,5,7..9,11..12 ; 5819
.shutter 0110101111001 0,2..3,5,7..10    ; 5820
.shutter 0110101111011 0,2..3,5,7..10,12 ; 5821
.shutter 0110101111101 0,2..3,5,7..11    ; 5822
.shutter 0110101111111 0,2..3,5,7..12    ; 5823
.shutter 0110110000001 0,2..3,5..6       ; 5824
.shutter 0110110000011 0,2..3,5..6,12    ; 5825
.shutter 0110110000101 0,2..3,5..6,11    ; 5826
.shutter 0110110000111 0,2..3,5..6,11..12 ; 5827
.shutter 0110110001001 0,2..3,5..6,10    ; 5828
.shutter 0110110001011 0,2..3,5..6,10,12 ; 5829
.shutter 0110110001101 0,2..3,5..6,10..11 ; 5830
.shutter 0110110001111 0,2..3,5..6,10..12 ; 5831
.shutter 0110110010001 0,2..3,5..6,9     ; 5832
.shutter 0110110010011 0,2..3,5..6,9,12  ; 5833
.shutter 0110110010101 0,2..3,5..6,9,11  ; 5834
.shutter 0110110010111 0,2..3,5..6,9,11..12 ; 5835
.shutter 0110110011001 0,2..3,5..6,9..10 ; 5836
.shutter 0110110011011 0,2..3,5..6,9..10,12 ; 5837
.shutter 0110110011101 0,2..3,5..6,9..11 ; 5838
.shutter 0110110011111 0,2..3,5..6,9..12 ; 5839
.shutter 0110110100001 0,2..3,5..6,8     ; 5840
.shutter 0110110100011 0,2..3,5..6,8,12  ; 5841
.shutter 0110110100101 0,2..3,5..6,8,11  ; 5842
.shutter 0110110100111 0,2..3,5..6,8,11..12 ; 5843
.shutter 0110110101001 0,2..3,5..6,8,10  ; 5844
.shutter 0110110101011 0,2..3,5..6,8..12/2 ; 5845
.shutter 0110110101101 0,2..3,5..6,8,10..11 ; 5846
.shutter 0110110101111 0,2..3,5..6,8,10..12 ; 5847
.shutter 0110110110001 0,2..3,5..6,8..9  ; 5848
.shutter 0110110110011 0,2..3,5..6,8..9,12 ; 5849
.shutter 0110110110101 0,2..3,5..6,8..9,11 ; 5850
.shutter 0110110110111 x6d1b             ; 5851
.shutter 0110110111001 0,2..3,5..6,8..10 ; 5852
.shutter 0110110111011 0,2..3,5..6,8..10,12 ; 5853
.shutter 0110110111101 0,2..3,5..6,8..11 ; 5854
.shutter 0110110111111 0,2..3,5..6,8..12 ; 5855
.shutter 0110111000001 0,2..3,5..7       ; 5856
.shutter 0110111000011 0,2..3,5..7,12    ; 5857
.shutter 0110111000101 0,2..3,5..7,11    ; 5858
.shutter 0110111000111 0,2..3,5..7,11..12 ; 5859
.shutter 0110111001001 0,2..3,5..7,10    ; 5860
.shutter 0110111001011 0,2..3,5..7,10,12 ; 5861
.shutter 0110111001101 0,2..3,5..7,10..11 ; 5862
.shutter 0110111001111 0,2..3,5..7,10..12 ; 5863
.shutter 0110111010001 0,2..3,5..7,9     ; 5864
.shutter 0110111010011 0,2..3,5..7,9,12  ; 5865
.shutter 0110111010101 0,2..3,5..7,9,11  ; 5866
.shutter 0110111010111 0,2..3,5..7,9,11..12 ; 5867
.shutter 0110111011001 0,2..3,5..7,9..10 ; 5868
.shutter 0110111011011 0,2..3,5..7,9..10,12 ; 5869
.shutter 0110111011101 0,2..3,5..7,9..11 ; 5870
.shutter 0110111011111 0,2..3,5..7,9..12 ; 5871
.shutter 0110111100001 0,2..3,5..8       ; 5872
.shutter 0110111100011 0,2..3,5..8,12    ; 5873
.shutter 0110111100101 0,2..3,5..8,11    ; 5874
.shutter 0110111100111 0,2..3,5..8,11..12 ; 5875
.shutter 0110111101001 0,2..3,5..8,10    ; 5876
.shutter 0110111101011 0,2..3,5..8,10,12 ; 5877
.shutter 0110111101101 0,2..3,5..8,10..11 ; 5878
.shutter 0110111101111 0,2..3,5..8,10..12 ; 5879
.shutter 0110111110001 0,2..3,5..9       ; 5880
.shutter 0110111110011 0,2..3,5..9,12    ; 5881
.shutter 0110111110101 0,2..3,5..9,11    ; 5882
.shutter 0110111110111 0,2..3,5..9,11..12 ; 5883
.shutter 0110111111001 0,2..3,5..10      ; 5884
.shutter 0110111111011 0,2..3,5..10,12   ; 5885
.shutter 0110111111101 0,2..3,5..11      ; 5886
.shutter 0110111111111 0,2..3,5..12      ; 5887
.shutter 0111000000001 0,2..4            ; 5888
.shutter 0111000000011 0,2..4,12         ; 5889
.shutter 0111000000101 0,2..4,11         ; 5890
.shutter 0111000000111 0,2..4,11..12     ; 5891
.shutter 0111000001001 0,2..4,10         ; 5892
.shutter 0111000001011 0,2..4,10,12      ; 5893
.shutter 0111000001101 0,2..4,10..11     ; 5894
.shutter 0111000001111 0,2..4,10..12     ; 5895
.shutter 0111000010001 0,2..4,9          ; 5896
.shutter 0111000010011 0,2..4,9,12       ; 5897
.shutter 0111000010101 0,2..4,9,11       ; 5898
.shutter 0111000010111 0,2..4,9,11..12   ; 5899
.shutter 0111000011001 0,2..4,9..10      ; 5900
.shutter 0111000011011 0,2..4,9..10,12   ; 5901
.shutter 0111000011101 0,2..4,9..11      ; 5902
.shutter 0111000011111 0,2..4,9..12      ; 5903
.shutter 0111000100001 0,2..4,8          ; 5904
.shutter 0111000100011 0,2..4,8,12       ; 5905
.shutter 0111000100101 0,2..4,8,11       ; 5906
.shutter 0111000100111 0,2..4,8,11..12   ; 5907
.shutter 0111000101001 0,2..4,8,10       ; 5908
.shutter 0111000101011 0,2..4,8..12/2    ; 5909
.shutter 0111000101101 0,2..4,8,10..11   ; 5910
.shutter 0111000101111 0,2..4,8,10..12   ; 5911
.shutter 0111000110001 0,2..4,8..9       ; 5912
.shutter 0111000110011 0,2..4,8..9,12    ; 5913
.shutter 0111000110101 0,2..4,8..9,11    ; 5914
.shutter 0111000110111 0,2..4,8..9,11..12 ; 5915
.shutter 0111000111001 0,2..4,8..10      ; 5916
.shutter 0111000111011 0,2..4,8..10,12   ; 5917
.shutter 0111000111101 0,2..4,8..11      ; 5918
.shutter 0111000111111 0,2..4,8..12      ; 5919
.shutter 0111001000001 0,2..4,7          ; 5920
.shutter 0111001000011 0,2..4,7,12       ; 5921
.shutter 0111001000101 0,2..4,7,11       ; 5922
.shutter 0111001000111 0,2..4,7,11..12   ; 5923
.shutter 0111001001001 0,2..4,7,10       ; 5924
.shutter 0111001001011 0,2..4,7,10,12    ; 5925
.shutter 0111001001101 0,2..4,7,10..11   ; 5926
.shutter 0111001001111 0,2..4,7,10..12   ; 5927
.shutter 0111001010001 0,2..4,7,9        ; 5928
.shutter 0111001010011 0,2..4,7,9,12     ; 5929
.shutter 0111001010101 0,2..4,7..11/2    ; 5930
.shutter 0111001010111 0,2..4,7..11/2,12 ; 5931
.shutter 0111001011001 0,2..4,7,9..10    ; 5932
.shutter 0111001011011 0,2..4,7,9..10,12 ; 5933
.shutter 0111001011101 0,2..4,7,9..11    ; 5934
.shutter 0111001011111 0,2..4,7,9..12    ; 5935
.shutter 0111001100001 0,2..4,7..8       ; 5936
.shutter 0111001100011 0,2..4,7..8,12    ; 5937
.shutter 0111001100101 0,2..4,7..8,11    ; 5938
.shutter 0111001100111 0,2..4,7..8,11..12 ; 5939
.shutter 0111001101001 0,2..4,7..8,10    ; 5940
.shutter 0111001101011 0,2..4,7..8,10,12 ; 5941
.shutter 0111001101101 0,2..4,7..8,10..11 ; 5942
.shutter 0111001101111 0,2..4,7..8,10..12 ; 5943
.shutter 0111001110001 0,2..4,7..9       ; 5944
.shutter 0111001110011 0,2..4,7..9,12    ; 5945
.shutter 0111001110101 0,2..4,7..9,11    ; 5946
.shutter 0111001110111 0,2..4,7..9,11..12 ; 5947
.shutter 0111001111001 0,2..4,7..10      ; 5948
.shutter 0111001111011 0,2..4,7..10,12   ; 5949
.shutter 0111001111101 0,2..4,7..11      ; 5950
.shutter 0111001111111 0,2..4,7..12      ; 5951
.shutter 0111010000001 0,2..4,6          ; 5952
.shutter 0111010000011 0,2..4,6,12       ; 5953
.shutter 0111010000101 0,2..4,6,11       ; 5954
.shutter 0111010000111 0,2..4,6,11..12   ; 5955
.shutter 0111010001001 0,2..4,6,10       ; 5956
.shutter 0111010001011 0,2..4,6,10,12    ; 5957
.shutter 0111010001101 0,2..4,6,10..11   ; 5958
.shutter 0111010001111 0,2..4,6,10..12   ; 5959
.shutter 0111010010001 0,2..4,6,9        ; 5960
.shutter 0111010010011 0,2..4,6..12/3    ; 5961
.shutter 0111010010101 0,2..4,6,9,11     ; 5962
.shutter 0111010010111 0,2..4,6,9,11..12 ; 5963
.shutter 0111010011001 0,2..4,6,9..10    ; 5964
.shutter 0111010011011 0,2..4,6,9..10,12 ; 5965
.shutter 0111010011101 0,2..4,6,9..11    ; 5966
.shutter 0111010011111 0,2..4,6,9..12    ; 5967
.shutter 0111010100001 0,2..4,6,8        ; 5968
.shutter 0111010100011 0,2..4,6,8,12     ; 5969
.shutter 0111010100101 0,2..4,6,8,11     ; 5970
.shutter 0111010100111 0,2..4,6,8,11..12 ; 5971
.shutter 0111010101001 0,2..4,6..10/2    ; 5972
.shutter 0111010101011 0,2..4,6..12/2    ; 5973
.shutter 0111010101101 0,2..4,6..10/2,11 ; 5974
.shutter 0111010101111 x5d1d             ; 5975
.shutter 0111010110001 0,2..4,6,8..9     ; 5976
.shutter 0111010110011 0,2..4,6,8..9,12  ; 5977
.shutter 0111010110101 0,2..4,6,8..9,11  ; 5978
.shutter 0111010110111 0,2..4,6,8..9,11..12 ; 5979
.shutter 0111010111001 0,2..4,6,8..10    ; 5980
.shutter 0111010111011 0,2..4,6,8..10,12 ; 5981
.shutter 0111010111101 0,2..4,6,8..11    ; 5982
.shutter 0111010111111 0,2..4,6,8..12    ; 5983
.shutter 0111011000001 0,2..4,6..7       ; 5984
.shutter 0111011000011 0,2..4,6..7,12    ; 5985
.shutter 0111011000101 0,2..4,6..7,11    ; 5986
.shutter 0111011000111 0,2..4,6..7,11..12 ; 5987
.shutter 0111011001001 0,2..4,6..7,10    ; 5988
.shutter 0111011001011 0,2..4,6..7,10,12 ; 5989
.shutter 0111011001101 0,2..4,6..7,10..11 ; 5990
.shutter 0111011001111 0,2..4,6..7,10..12 ; 5991
.shutter 0111011010001 0,2..4,6..7,9     ; 5992
.shutter 0111011010011 0,2..4,6..7,9,12  ; 5993
.shutter 0111011010101 0,2..4,6..7,9,11  ; 5994
.shutter 0111011010111 0,2..4,6..7,9,11..12 ; 5995
.shutter 0111011011001 0,2..4,6..7,9..10 ; 5996
.shutter 0111011011011 0,2..4,6..7,9..10,12 ; 5997
.shutter 0111011011101 0,2..4,6..7,9..11 ; 5998
.shutter 0111011011111 0,2..4,6..7,9..12 ; 5999
.shutter 0111011100001 0,2..4,6..8       ; 6000
.shutter 0111011100011 0,2..4,6..8,12    ; 6001
.shutter 0111011100101 0,2..4,6..8,11    ; 6002
.shutter 0111011100111 0,2..4,6..8,11..12 ; 6003
.shutter 0111011101001 0,2..4,6..8,10    ; 6004
.shutter 0111011101011 0,2..4,6..8,10,12 ; 6005
.shutter 0111011101101 0,2..4,6..8,10..11 ; 6006
.shutter 0111011101111 0,2..4,6..8,10..12 ; 6007
.shutter 0111011110001 0,2..4,6..9       ; 6008
.shutter 0111011110011 0,2..4,6..9,12    ; 6009
.shutter 0111011110101 0,2..4,6..9,11    ; 6010
.shutter 0111011110111 0,2..4,6..9,11..12 ; 6011
.shutter 0111011111001 0,2..4,6..10      ; 6012
.shutter 0111011111011 0,2..4,6..10,12   ; 6013
.shutter 0111011111101 0,2..4,6..11      ; 6014
.shutter 0111011111111 0,2..4,6..12      ; 6015
.shutter 0111100000001 0,2..5            ; 6016
.shutter 0111100000011 0,2..5,12         ; 6017
.shutter 0111100000101 0,2..5,11         ; 6018
.shutter 0111100000111 0,2..5,11..12     ; 6019
.shutter 0111100001001 0,2..5,10         ; 6020
.shutter 0111100001011 0,2..5,10,12      ; 6021
.shutter 0111100001101 0,2..5,10..11     ; 6022
.shutter 0111100001111 0,2..5,10..12     ; 6023
.shutter 0111100010001 0,2..5,9          ; 6024
.shutter 0111100010011 0,2..5,9,12       ; 6025
.shutter 0111100010101 0,2..5,9,11       ; 6026
.shutter 0111100010111 0,2..5,9,11..12   ; 6027
.shutter 0111100011001 0,2..5,9..10      ; 6028
.shutter 0111100011011 0,2..5,9..10,12   ; 6029
.shutter 0111100011101 0,2..5,9..11      ; 6030
.shutter 0111100011111 0,2..5,9..12      ; 6031
.shutter 0111100100001 0,2..5,8          ; 6032
.shutter 0111100100011 0,2..5,8,12       ; 6033
.shutter 0111100100101 0,2..5,8,11       ; 6034
.shutter 0111100100111 0,2..5,8,11..12   ; 6035
.shutter 0111100101001 0,2..5,8,10       ; 6036
.shutter 0111100101011 0,2..5,8..12/2    ; 6037
.shutter 0111100101101 0,2..5,8,10..11   ; 6038
.shutter 0111100101111 0,2..5,8,10..12   ; 6039
.shutter 0111100110001 0,2..5,8..9       ; 6040
.shutter 0111100110011 0,2..5,8..9,12    ; 6041
.shutter 0111100110101 0,2..5,8..9,11    ; 6042
.shutter 0111100110111 0,2..5,8..9,11..12 ; 6043
.shutter 0111100111001 0,2..5,8..10      ; 6044
.shutter 0111100111011 0,2..5,8..10,12   ; 6045
.shutter 0111100111101 0,2..5,8..11      ; 6046
.shutter 0111100111111 0,2..5,8..12      ; 6047
.shutter 0111101000001 0,2..5,7          ; 6048
.shutter 0111101000011 0,2..5,7,12       ; 6049
.shutter 0111101000101 0,2..5,7,11       ; 6050
.shutter 0111101000111 0,2..5,7,11..12   ; 6051
.shutter 0111101001001 0,2..5,7,10       ; 6052
.shutter 0111101001011 0,2..5,7,10,12    ; 6053
.shutter 0111101001101 0,2..5,7,10..11   ; 6054
.shutter 0111101001111 0,2..5,7,10..12   ; 6055
.shutter 0111101010001 0,2..5,7,9        ; 6056
.shutter 0111101010011 0,2..5,7,9,12     ; 6057
.shutter 0111101010101 0,2..5,7..11/2    ; 6058
.shutter 0111101010111 0,2..5,7..11/2,12 ; 6059
.shutter 0111101011001 0,2..5,7,9..10    ; 6060
.shutter 0111101011011 0,2..5,7,9..10,12 ; 6061
.shutter 0111101011101 0,2..5,7,9..11    ; 6062
.shutter 0111101011111 0,2..5,7,9..12    ; 6063
.shutter 0111101100001 0,2..5,7..8       ; 6064
.shutter 0111101100011 0,2..5,7..8,12    ; 6065
.shutter 0111101100101 0,2..5,7..8,11    ; 6066
.shutter 0111101100111 0,2..5,7..8,11..12 ; 6067
.shutter 0111101101001 0,2..5,7..8,10    ; 6068
.shutter 0111101101011 0,2..5,7..8,10,12 ; 6069
.shutter 0111101101101 0,2..5,7..8,10..11 ; 6070
.shutter 0111101101111 0,2..5,7..8,10..12 ; 6071
.shutter 0111101110001 0,2..5,7..9       ; 6072
.shutter 0111101110011 0,2..5,7..9,12    ; 6073
.shutter 0111101110101 0,2..5,7..9,11    ; 6074
.shutter 0111101110111 0,2..5,7..9,11..12 ; 6075
.shutter 0111101111001 0,2..5,7..10      ; 6076
.shutter 0111101111011 0,2..5,7..10,12   ; 6077
.shutter 0111101111101 0,2..5,7..11      ; 6078
.shutter 0111101111111 0,2..5,7..12      ; 6079
.shutter 0111110000001 0,2..6            ; 6080
.shutter 0111110000011 0,2..6,12         ; 6081
.shutter 0111110000101 0,2..6,11         ; 6082
.shutter 0111110000111 0,2..6,11..12     ; 6083
.shutter 0111110001001 0,2..6,10         ; 6084
.shutter 0111110001011 0,2..6,10,12      ; 6085
.shutter 0111110001101 0,2..6,10..11     ; 6086
.shutter 0111110001111 0,2..6,10..12     ; 6087
.shutter 0111110010001 0,2..6,9          ; 6088
.shutter 0111110010011 0,2..6,9,12       ; 6089
.shutter 0111110010101 0,2..6,9,11       ; 6090
.shutter 0111110010111 0,2..6,9,11..12   ; 6091
.shutter 0111110011001 0,2..6,9..10      ; 6092
.shutter 0111110011011 0,2..6,9..10,12   ; 6093
.shutter 0111110011101 0,2..6,9..11      ; 6094
.shutter 0111110011111 0,2..6,9..12      ; 6095
.shutter 0111110100001 0,2..6,8          ; 6096
.shutter 0111110100011 0,2..6,8,12       ; 6097
.shutter 0111110100101 0,2..6,8,11       ; 6098
.shutter 0111110100111 0,2..6,8,11..12   ; 6099
.shutter 0111110101001 0,2..6,8,10       ; 6100
.shutter 0111110101011 0,2..6,8..12/2    ; 6101
.shutter 0111110101101 0,2..6,8,10..11   ; 6102
.shutter 0111110101111 0,2..6,8,10..12   ; 6103
.shutter 0111110110001 0,2..6,8..9       ; 6104
.shutter 0111110110011 0,2..6,8..9,12    ; 6105
.shutter 0111110110101 0,2..6,8..9,11    ; 6106
.shutter 0111110110111 0,2..6,8..9,11..12 ; 6107
.shutter 0111110111001 0,2..6,8..10      ; 6108
.shutter 0111110111011 0,2..6,8..10,12   ; 6109
.shutter 0111110111101 0,2..6,8..11      ; 6110
.shutter 0111110111111 0,2..6,8..12      ; 6111
.shutter 0111111000001 0,2..7            ; 6112
.shutter 0111111000011 0,2..7,12         ; 6113
.shutter 0111111000101 0,2..7,11         ; 6114
.shutter 0111111000111 0,2..7,11..12     ; 6115
.shutter 0111111001001 0,2..7,10         ; 6116
.shutter 0111111001011 0,2..7,10,12      ; 6117
.shutter 0111111001101 0,2..7,10..11     ; 6118
.shutter 0111111001111 0,2..7,10..12     ; 6119
.shutter 0111111010001 0,2..7,9          ; 6120
.shutter 0111111010011 0,2..7,9,12       ; 6121
.shutter 0111111010101 0,2..7,9,11       ; 6122
.shutter 0111111010111 0,2..7,9,11..12   ; 6123
.shutter 0111111011001 0,2..7,9..10      ; 6124
.shutter 0111111011011 0,2..7,9..10,12   ; 6125
.shutter 0111111011101 0,2..7,9..11      ; 6126
.shutter 0111111011111 0,2..7,9..12      ; 6127
.shutter 0111111100001 0,2..8            ; 6128
.shutter 0111111100011 0,2..8,12         ; 6129
.shutter 0111111100101 0,2..8,11         ; 6130
.shutter 0111111100111 0,2..8,11..12     ; 6131
.shutter 0111111101001 0,2..8,10         ; 6132
.shutter 0111111101011 0,2..8,10,12      ; 6133
.shutter 0111111101101 0,2..8,10..11     ; 6134
.shutter 0111111101111 0,2..8,10..12     ; 6135
.shutter 0111111110001 0,2..9            ; 6136
.shutter 0111111110011 0,2..9,12         ; 6137
.shutter 0111111110101 0,2..9,11         ; 6138
.shutter 0111111110111 0,2..9,11..12     ; 6139
.shutter 0111111111001 0,2..10           ; 6140
.shutter 0111111111011 0,2..10,12        ; 6141
.shutter 0111111111101 0,2..11           ; 6142
.shutter 0111111111111 0,2..12           ; 6143
.shutter 1000000000001 0..1              ; 6144
.shutter 1000000000011 0..1,12           ; 6145
.shutter 1000000000101 0..1,11           ; 6146
.shutter 1000000000111 0..1,11..12       ; 6147
.shutter 1000000001001 0..1,10           ; 6148
.shutter 1000000001011 0..1,10,12        ; 6149
.shutter 1000000001101 0..1,10..11       ; 6150
.shutter 1000000001111 0..1,10..12       ; 6151
.shutter 1000000010001 0..1,9            ; 6152
.shutter 1000000010011 0..1,9,12         ; 6153
.shutter 1000000010101 0..1,9,11         ; 6154
.shutter 1000000010111 0..1,9,11..12     ; 6155
.shutter 1000000011001 0..1,9..10        ; 6156
.shutter 1000000011011 0..1,9..10,12     ; 6157
.shutter 1000000011101 0..1,9..11        ; 6158
.shutter 1000000011111 0..1,9..12        ; 6159
.shutter 1000000100001 0..1,8            ; 6160
.shutter 1000000100011 0..1,8,12         ; 6161
.shutter 1000000100101 0..1,8,11         ; 6162
.shutter 1000000100111 0..1,8,11..12     ; 6163
.shutter 1000000101001 0..1,8,10         ; 6164
.shutter 1000000101011 0..1,8,10,12      ; 6165
.shutter 1000000101101 0..1,8,10..11     ; 6166
.shutter 1000000101111 0..1,8,10..12     ; 6167
.shutter 1000000110001 0..1,8..9         ; 6168
.shutter 1000000110011 0..1,8..9,12      ; 6169
.shutter 1000000110101 0..1,8..9,11      ; 6170
.shutter 1000000110111 0..1,8..9,11..12  ; 6171
.shutter 1000000111001 0..1,8..10        ; 6172
.shutter 1000000111011 0..1,8..10,12     ; 6173
.shutter 1000000111101 0..1,8..11        ; 6174
.shutter 1000000111111 0..1,8..12        ; 6175
.shutter 1000001000001 0..1,7            ; 6176
.shutter 1000001000011 0..1,7,12         ; 6177
.shutter 1000001000101 0..1,7,11         ; 6178
.shutter 1000001000111 0..1,7,11..12     ; 6179
.shutter 1000001001001 0..1,7,10         ; 6180
.shutter 1000001001011 0..1,7,10,12      ; 6181
.shutter 1000001001101 0..1,7,10..11     ; 6182
.shutter 1000001001111 0..1,7,10..12     ; 6183
.shutter 1000001010001 0..1,7,9          ; 6184
.shutter 1000001010011 0..1,7,9,12       ; 6185
.shutter 1000001010101 0..1,7,9,11       ; 6186
.shutter 1000001010111 0..1,7,9,11..12   ; 6187
.shutter 1000001011001 0..1,7,9..10      ; 6188
.shutter 1000001011011 0..1,7,9..10,12   ; 6189
.shutter 1000001011101 0..1,7,9..11      ; 6190
.shutter 1000001011111 0..1,7,9..12      ; 6191
.shutter 1000001100001 0..1,7..8         ; 6192
.shutter 1000001100011 0..1,7..8,12      ; 6193
.shutter 1000001100101 0..1,7..8,11      ; 6194
.shutter 1000001100111 0..1,7..8,11..12  ; 6195
.shutter 1000001101001 0..1,7..8,10      ; 6196
.shutter 1000001101011 0..1,7..8,10,12   ; 6197
.shutter 1000001101101 0..1,7..8,10..11  ; 6198
.shutter 1000001101111 0..1,7..8,10..12  ; 6199
.shutter 1000001110001 0..1,7..9         ; 6200
.shutter 1000001110011 0..1,7..9,12      ; 6201
.shutter 1000001110101 0..1,7..9,11      ; 6202
.shutter 1000001110111 0..1,7..9,11..12  ; 6203
.shutter 1000001111001 0..1,7..10        ; 6204
.shutter 1000001111011 0..1,7..10,12     ; 6205
.shutter 1000001111101 0..1,7..11        ; 6206
.shutter 1000001111111 0..1,7..12        ; 6207
.shutter 1000010000001 0..1,6            ; 6208
.shutter 1000010000011 0..1,6,12         ; 6209
.shutter 1000010000101 0..1,6,11         ; 6210
.shutter 1000010000111 0..1,6,11..12     ; 6211
.shutter 1000010001001 0..1,6,10         ; 6212
.shutter 1000010001011 0..1,6,10,12      ; 6213
.shutter 1000010001101 0..1,6,10..11     ; 6214
.shutter 1000010001111 0..1,6,10..12     ; 6215
.shutter 1000010010001 0..1,6,9          ; 6216
.shutter 1000010010011 0..1,6,9,12       ; 6217
.shutter 1000010010101 0..1,6,9,11       ; 6218
.shutter 1000010010111 0..1,6,9,11..12   ; 6219
.shutter 1000010011001 0..1,6,9..10      ; 6220
.shutter 1000010011011 0..1,6,9..10,12   ; 6221
.shutter 1000010011101 0..1,6,9..11      ; 6222
.shutter 1000010011111 0..1,6,9..12      ; 6223
.shutter 1000010100001 0..1,6,8          ; 6224
.shutter 1000010100011 0..1,6,8,12       ; 6225
.shutter 1000010100101 0..1,6,8,11       ; 6226
.shutter 1000010100111 0..1,6,8,11..12   ; 6227
.shutter 1000010101001 0..1,6,8,10       ; 6228
.shutter 1000010101011 0..1,6..12/2      ; 6229
.shutter 1000010101101 0..1,6,8,10..11   ; 6230
.shutter 1000010101111 0..1,6,8,10..12   ; 6231
.shutter 1000010110001 0..1,6,8..9       ; 6232
.shutter 1000010110011 0..1,6,8..9,12    ; 6233
.shutter 1000010110101 0..1,6,8..9,11    ; 6234
.shutter 1000010110111 0..1,6,8..9,11..12 ; 6235
.shutter 1000010111001 0..1,6,8..10      ; 6236
.shutter 1000010111011 0..1,6,8..10,12   ; 6237
.shutter 1000010111101 0..1,6,8..11      ; 6238
.shutter 1000010111111 0..1,6,8..12      ; 6239
.shutter 1000011000001 0..1,6..7         ; 6240
.shutter 1000011000011 0..1,6..7,12      ; 6241
.shutter 1000011000101 0..1,6..7,11      ; 6242
.shutter 1000011000111 0..1,6..7,11..12  ; 6243
.shutter 1000011001001 0..1,6..7,10      ; 6244
.shutter 1000011001011 0..1,6..7,10,12   ; 6245
.shutter 1000011001101 0..1,6..7,10..11  ; 6246
.shutter 1000011001111 0..1,6..7,10..12  ; 6247
.shutter 1000011010001 0..1,6..7,9       ; 6248
.shutter 1000011010011 0..1,6..7,9,12    ; 6249
.shutter 1000011010101 0..1,6..7,9,11    ; 6250
.shutter 1000011010111 0..1,6..7,9,11..12 ; 6251
.shutter 1000011011001 0..1,6..7,9..10   ; 6252
.shutter 1000011011011 0..1,6..7,9..10,12 ; 6253
.shutter 1000011011101 0..1,6..7,9..11   ; 6254
.shutter 1000011011111 0..1,6..7,9..12   ; 6255
.shutter 1000011100001 0..1,6..8         ; 6256
.shutter 1000011100011 0..1,6..8,12      ; 6257
.shutter 1000011100101 0..1,6..8,11      ; 6258
.shutter 1000011100111 0..1,6..8,11..12  ; 6259
.shutter 1000011101001 0..1,6..8,10      ; 6260
.shutter 1000011101011 0..1,6..8,10,12   ; 6261
.shutter 1000011101101 0..1,6..8,10..11  ; 6262
.shutter 1000011101111 0..1,6..8,10..12  ; 6263
.shutter 1000011110001 0..1,6..9         ; 6264
.shutter 1000011110011 0..1,6..9,12      ; 6265
.shutter 1000011110101 0..1,6..9,11      ; 6266
.shutter 1000011110111 0..1,6..9,11..12  ; 6267
.shutter 1000011111001 0..1,6..10        ; 6268
.shutter 1000011111011 0..1,6..10,12     ; 6269
.shutter 1000011111101 0..1,6..11        ; 6270
.shutter 1000011111111 0..1,6..12        ; 6271
.shutter 1000100000001 0..1,5            ; 6272
.shutter 1000100000011 0..1,5,12         ; 6273
.shutter 1000100000101 0..1,5,11         ; 6274
.shutter 1000100000111 0..1,5,11..12     ; 6275
.shutter 1000100001001 0..1,5,10         ; 6276
.shutter 1000100001011 0..1,5,10,12      ; 6277
.shutter 1000100001101 0..1,5,10..11     ; 6278
.shutter 1000100001111 0..1,5,10..12     ; 6279
.shutter 1000100010001 0..1,5,9          ; 6280
.shutter 1000100010011 0..1,5,9,12       ; 6281
.shutter 1000100010101 0..1,5,9,11       ; 6282
.shutter 1000100010111 0..1,5,9,11..12   ; 6283
.shutter 1000100011001 0..1,5,9..10      ; 6284
.shutter 1000100011011 0..1,5,9..10,12   ; 6285
.shutter 1000100011101 0..1,5,9..11      ; 6286
.shutter 1000100011111 0..1,5,9..12      ; 6287
.shutter 1000100100001 0..1,5,8          ; 6288
.shutter 1000100100011 0..1,5,8,12       ; 6289
.shutter 1000100100101 0..1,5,8,11       ; 6290
.shutter 1000100100111 0..1,5,8,11..12   ; 6291
.shutter 1000100101001 0..1,5,8,10       ; 6292
.shutter 1000100101011 0..1,5,8..12/2    ; 6293
.shutter 1000100101101 0..1,5,8,10..11   ; 6294
.shutter 1000100101111 0..1,5,8,10..12   ; 6295
.shutter 1000100110001 0..1,5,8..9       ; 6296
.shutter 1000100110011 0..1,5,8..9,12    ; 6297
.shutter 1000100110101 0..1,5,8..9,11    ; 6298
.shutter 1000100110111 0..1,5,8..9,11..12 ; 6299
.shutter 1000100111001 0..1,5,8..10      ; 6300
.shutter 1000100111011 0..1,5,8..10,12   ; 6301
.shutter 1000100111101 0..1,5,8..11      ; 6302
.shutter 1000100111111 0..1,5,8..12      ; 6303
.shutter 1000101000001 0..1,5,7          ; 6304
.shutter 1000101000011 0..1,5,7,12       ; 6305
.shutter 1000101000101 0..1,5,7,11       ; 6306
.shutter 1000101000111 0..1,5,7,11..12   ; 6307
.shutter 1000101001001 0..1,5,7,10       ; 6308
.shutter 1000101001011 0..1,5,7,10,12    ; 6309
.shutter 1000101001101 0..1,5,7,10..11   ; 6310
.shutter 1000101001111 0..1,5,7,10..12   ; 6311
.shutter 1000101010001 0..1,5,7,9        ; 6312
.shutter 1000101010011 0..1,5..9/2,12    ; 6313
.shutter 1000101010101 0..1,5..11/2      ; 6314
.shutter 1000101010111 0..1,5..11/2,12   ; 6315
.shutter 1000101011001 0..1,5,7,9..10    ; 6316
.shutter 1000101011011 0..1,5..9/2,10,12 ; 6317
.shutter 1000101011101 0..1,5,7,9..11    ; 6318
.shutter 1000101011111 0..1,5,7,9..12    ; 6319
.shutter 1000101100001 0..1,5,7..8       ; 6320
.shutter 1000101100011 0..1,5,7..8,12    ; 6321
.shutter 1000101100101 0..1,5,7..8,11    ; 6322
.shutter 1000101100111 0..1,5,7..8,11..12 ; 6323
.shutter 1000101101001 0..1,5,7..8,10    ; 6324
.shutter 1000101101011 0..1,5,7..8,10,12 ; 6325
.shutter 1000101101101 0..1,5,7..8,10..11 ; 6326
.shutter 1000101101111 0..1,5,7..8,10..12 ; 6327
.shutter 1000101110001 0..1,5,7..9       ; 6328
.shutter 1000101110011 0..1,5,7..9,12    ; 6329
.shutter 1000101110101 0..1,5,7..9,11    ; 6330
.shutter 1000101110111 0..1,5,7..9,11..12 ; 6331
.shutter 1000101111001 0..1,5,7..10      ; 6332
.shutter 1000101111011 0..1,5,7..10,12   ; 6333
.shutter 1000101111101 0..1,5,7..11      ; 6334
.shutter 1000101111111 0..1,5,7..12      ; 6335
.shutter 1000110000001 0..1,5..6         ; 6336
.shutter 1000110000011 0..1,5..6,12      ; 6337
.shutter 1000110000101 0..1,5..6,11      ; 6338
.shutter 1000110000111 0..1,5..6,11..12  ; 6339
.shutter 1000110001001 0..1,5..6,10      ; 6340
.shutter 1000110001011 0..1,5..6,10,12   ; 6341
.shutter 1000110001101 0..1,5..6,10..11  ; 6342
.shutter 1000110001111 0..1,5..6,10..12  ; 6343
.shutter 1000110010001 0..1,5..6,9       ; 6344
.shutter 1000110010011 0..1,5..6,9,12    ; 6345
.shutter 1000110010101 0..1,5..6,9,11    ; 6346
.shutter 1000110010111 0..1,5..6,9,11..12 ; 6347
.shutter 1000110011001 0..1,5..6,9..10   ; 6348
.shutter 1000110011011 0..1,5..6,9..10,12 ; 6349
.shutter 1000110011101 0..1,5..6,9..11   ; 6350
.shutter 1000110011111 0..1,5..6,9..12   ; 6351
.shutter 1000110100001 0..1,5..6,8       ; 6352
.shutter 1000110100011 0..1,5..6,8,12    ; 6353
.shutter 1000110100101 0..1,5..6,8,11    ; 6354
.shutter 1000110100111 0..1,5..6,8,11..12 ; 6355
.shutter 1000110101001 0..1,5..6,8,10    ; 6356
.shutter 1000110101011 0..1,5..6,8..12/2 ; 6357
.shutter 1000110101101 0..1,5..6,8,10..11 ; 6358
.shutter 1000110101111 0..1,5..6,8,10..12 ; 6359
.shutter 1000110110001 0..1,5..6,8..9    ; 6360
.shutter 1000110110011 0..1,5..6,8..9,12 ; 6361
.shutter 1000110110101 0..1,5..6,8..9,11 ; 6362
.shutter 1000110110111 0..1,5..6,8..9,11..12 ; 6363
.shutter 1000110111001 0..1,5..6,8..10   ; 6364
.shutter 1000110111011 0..1,5..6,8..10,12 ; 6365
.shutter 1000110111101 0..1,5..6,8..11   ; 6366
.shutter 1000110111111 0..1,5..6,8..12   ; 6367
.shutter 1000111000001 0..1,5..7         ; 6368
.shutter 1000111000011 0..1,5..7,12      ; 6369
.shutter 1000111000101 0..1,5..7,11      ; 6370
.shutter 1000111000111 0..1,5..7,11..12  ; 6371
.shutter 1000111001001 0..1,5..7,10      ; 6372
.shutter 1000111001011 0..1,5..7,10,12   ; 6373
.shutter 1000111001101 0..1,5..7,10..11  ; 6374
.shutter 1000111001111 0..1,5..7,10..12  ; 6375
.shutter 1000111010001 0..1,5..7,9       ; 6376
.shutter 1000111010011 0..1,5..7,9,12    ; 6377
.shutter 1000111010101 0..1,5..7,9,11    ; 6378
.shutter 1000111010111 0..1,5..7,9,11..12 ; 6379
.shutter 1000111011001 0..1,5..7,9..10   ; 6380
.shutter 1000111011011 0..1,5..7,9..10,12 ; 6381
.shutter 1000111011101 0..1,5..7,9..11   ; 6382
.shutter 1000111011111 0..1,5..7,9..12   ; 6383
.shutter 1000111100001 0..1,5..8         ; 6384
.shutter 1000111100011 0..1,5..8,12      ; 6385
.shutter 1000111100101 0..1,5..8,11      ; 6386
.shutter 1000111100111 0..1,5..8,11..12  ; 6387
.shutter 1000111101001 0..1,5..8,10      ; 6388
.shutter 1000111101011 0..1,5..8,10,12   ; 6389
.shutter 1000111101101 0..1,5..8,10..11  ; 6390
.shutter 1000111101111 0..1,5..8,10..12  ; 6391
.shutter 1000111110001 0..1,5..9         ; 6392
.shutter 1000111110011 0..1,5..9,12      ; 6393
.shutter 1000111110101 0..1,5..9,11      ; 6394
.shutter 1000111110111 0..1,5..9,11..12  ; 6395
.shutter 1000111111001 0..1,5..10        ; 6396
.shutter 1000111111011 0..1,5..10,12     ; 6397
.shutter 1000111111101 0..1,5..11        ; 6398
.shutter 1000111111111 0..1,5..12        ; 6399
.shutter 1001000000001 0..1,4            ; 6400
.shutter 1001000000011 0..1,4,12         ; 6401
.shutter 1001000000101 0..1,4,11         ; 6402
.shutter 1001000000111 0..1,4,11..12     ; 6403
.shutter 1001000001001 0..1,4,10         ; 6404
.shutter 1001000001011 0..1,4,10,12      ; 6405
.shutter 1001000001101 0..1,4,10..11     ; 6406
.shutter 1001000001111 0..1,4,10..12     ; 6407
.shutter 1001000010001 0..1,4,9          ; 6408
.shutter 1001000010011 0..1,4,9,12       ; 6409
.shutter 1001000010101 0..1,4,9,11       ; 6410
.shutter 1001000010111 0..1,4,9,11..12   ; 6411
.shutter 1001000011001 0..1,4,9..10      ; 6412
.shutter 1001000011011 0..1,4,9..10,12   ; 6413
.shutter 1001000011101 0..1,4,9..11      ; 6414
.shutter 1001000011111 0..1,4,9..12      ; 6415
.shutter 1001000100001 0..1,4,8          ; 6416
.shutter 1001000100011 0..1,4,8,12       ; 6417
.shutter 1001000100101 0..1,4,8,11       ; 6418
.shutter 1001000100111 0..1,4,8,11..12   ; 6419
.shutter 1001000101001 0..1,4,8,10       ; 6420
.shutter 1001000101011 0..1,4,8..12/2    ; 6421
.shutter 1001000101101 0..1,4,8,10..11   ; 6422
.shutter 1001000101111 0..1,4,8,10..12   ; 6423
.shutter 1001000110001 0..1,4,8..9       ; 6424
.shutter 1001000110011 0..1,4,8..9,12    ; 6425
.shutter 1001000110101 0..1,4,8..9,11    ; 6426
.shutter 1001000110111 0..1,4,8..9,11..12 ; 6427
.shutter 1001000111001 0..1,4,8..10      ; 6428
.shutter 1001000111011 0..1,4,8..10,12   ; 6429
.shutter 1001000111101 0..1,4,8..11      ; 6430
.shutter 1001000111111 0..1,4,8..12      ; 6431
.shutter 1001001000001 0..1,4,7          ; 6432
.shutter 1001001000011 0..1,4,7,12       ; 6433
.shutter 1001001000101 0..1,4,7,11       ; 6434
.shutter 1001001000111 0..1,4,7,11..12   ; 6435
.shutter 1001001001001 0..1,4,7,10       ; 6436
.shutter 1001001001011 0..1,4..10/3,12   ; 6437
.shutter 1001001001101 0..1,4,7,10..11   ; 6438
.shutter 1001001001111 0..1,4,7,10..12   ; 6439
.shutter 1001001010001 0..1,4,7,9        ; 6440
.shutter 1001001010011 0..1,4,7,9,12     ; 6441
.shutter 1001001010101 0..1,4,7..11/2    ; 6442
.shutter 1001001010111 0..1,4,7..11/2,12 ; 6443
.shutter 1001001011001 0..1,4,7,9..10    ; 6444
.shutter 1001001011011 0..1,4,7,9..10,12 ; 6445
.shutter 1001001011101 0..1,4,7,9..11    ; 6446
.shutter 1001001011111 0..1,4,7,9..12    ; 6447
.shutter 1001001100001 0..1,4,7..8       ; 6448
.shutter 1001001100011 0..1,4,7..8,12    ; 6449
.shutter 1001001100101 0..1,4,7..8,11    ; 6450
.shutter 1001001100111 0..1,4,7..8,11..12 ; 6451
.shutter 1001001101001 0..1,4,7..8,10    ; 6452
.shutter 1001001101011 0..1,4,7..8,10,12 ; 6453
.shutter 1001001101101 0..1,4,7..8,10..11 ; 6454
.shutter 1001001101111 0..1,4,7..8,10..12 ; 6455
.shutter 1001001110001 0..1,4,7..9       ; 6456
.shutter 1001001110011 0..1,4,7..9,12    ; 6457
.shutter 1001001110101 0..1,4,7..9,11    ; 6458
.shutter 1001001110111 0..1,4,7..9,11..12 ; 6459
.shutter 1001001111001 0..1,4,7..10      ; 6460
.shutter 1001001111011 0..1,4,7..10,12   ; 6461
.shutter 1001001111101 0..1,4,7..11      ; 6462
.shutter 1001001111111 0..1,4,7..12      ; 6463
.shutter 1001010000001 0..1,4,6          ; 6464
.shutter 1001010000011 0..1,4,6,12       ; 6465
.shutter 1001010000101 0..1,4,6,11       ; 6466
.shutter 1001010000111 0..1,4,6,11..12   ; 6467
.shutter 1001010001001 0..1,4,6,10       ; 6468
.shutter 1001010001011 0..1,4,6,10,12    ; 6469
.shutter 1001010001101 0..1,4,6,10..11   ; 6470
.shutter 1001010001111 0..1,4,6,10..12   ; 6471
.shutter 1001010010001 0..1,4,6,9        ; 6472
.shutter 1001010010011 0..1,4,6..12/3    ; 6473
.shutter 1001010010101 0..1,4,6,9,11     ; 6474
.shutter 1001010010111 0..1,4,6,9,11..12 ; 6475
.shutter 1001010011001 0..1,4,6,9..10    ; 6476
.shutter 1001010011011 0..1,4,6,9..10,12 ; 6477
.shutter 1001010011101 0..1,4,6,9..11    ; 6478
.shutter 1001010011111 0..1,4,6,9..12    ; 6479
.shutter 1001010100001 0..1,4,6,8        ; 6480
.shutter 1001010100011 0..1,4..8/2,12    ; 6481
.shutter 1001010100101 0..1,4..8/2,11    ; 6482
.shutter 1001010100111 0..1,4..8/2,11..12 ; 6483
.shutter 1001010101001 0..1,4..10/2      ; 6484
.shutter 1001010101011 0..1,4..12/2      ; 6485
.shutter 1001010101101 0..1,4..10/2,11   ; 6486
.shutter 1001010101111 0..1,4..10/2,11..12 ; 6487
.shutter 1001010110001 0..1,4,6,8..9     ; 6488
.shutter 1001010110011 0..1,4..8/2,9,12  ; 6489
.shutter 1001010110101 0..1,4..8/2,9,11  ; 6490
.shutter 1001010110111 0..1,4..8/2,9,11..12 ; 6491
.shutter 1001010111001 0..1,4,6,8..10    ; 6492
.shutter 1001010111011 0..1,4..8/2,9..10,12 ; 6493
.shutter 1001010111101 0..1,4,6,8..11    ; 6494
.shutter 1001010111111 0..1,4,6,8..12    ; 6495
.shutter 1001011000001 0..1,4,6..7       ; 6496
.shutter 1001011000011 0..1,4,6..7,12    ; 6497
.shutter 1001011000101 0..1,4,6..7,11    ; 6498
.shutter 1001011000111 0..1,4,6..7,11..12 ; 6499
.shutter 1001011001001 0..1,4,6..7,10    ; 6500
.shutter 1001011001011 0..1,4,6..7,10,12 ; 6501
.shutter 1001011001101 0..1,4,6..7,10..11 ; 6502
.shutter 1001011001111 0..1,4,6..7,10..12 ; 6503
.shutter 1001011010001 0..1,4,6..7,9     ; 6504
.shutter 1001011010011 0..1,4,6..7,9,12  ; 6505
.shutter 1001011010101 0..1,4,6..7,9,11  ; 6506
.shutter 1001011010111 0..1,4,6..7,9,11..12 ; 6507
.shutter 1001011011001 0..1,4,6..7,9..10 ; 6508
.shutter 1001011011011 0..1,4,6..7,9..10,12 ; 6509
.shutter 1001011011101 0..1,4,6..7,9..11 ; 6510
.shutter 1001011011111 0..1,4,6..7,9..12 ; 6511
.shutter 1001011100001 0..1,4,6..8       ; 6512
.shutter 1001011100011 0..1,4,6..8,12    ; 6513
.shutter 1001011100101 0..1,4,6..8,11    ; 6514
.shutter 1001011100111 0..1,4,6..8,11..12 ; 6515
.shutter 1001011101001 0..1,4,6..8,10    ; 6516
.shutter 1001011101011 0..1,4,6..8,10,12 ; 6517
.shutter 1001011101101 0..1,4,6..8,10..11 ; 6518
.shutter 1001011101111 0..1,4,6..8,10..12 ; 6519
.shutter 1001011110001 0..1,4,6..9       ; 6520
.shutter 1001011110011 0..1,4,6..9,12    ; 6521
.shutter 1001011110101 0..1,4,6..9,11    ; 6522
.shutter 1001011110111 0..1,4,6..9,11..12 ; 6523
.shutter 1001011111001 0..1,4,6..10      ; 6524
.shutter 1001011111011 0..1,4,6..10,12   ; 6525
.shutter 1001011111101 0..1,4,6..11      ; 6526
.shutter 1001011111111 0..1,4,6..12      ; 6527
.shutter 1001100000001 0..1,4..5         ; 6528
.shutter 1001100000011 0..1,4..5,12      ; 6529
.shutter 1001100000101 0..1,4..5,11      ; 6530
.shutter 1001100000111 0..1,4..5,11..12  ; 6531
.shutter 1001100001001 0..1,4..5,10      ; 6532
.shutter 1001100001011 0..1,4..5,10,12   ; 6533
.shutter 1001100001101 0..1,4..5,10..11  ; 6534
.shutter 1001100001111 0..1,4..5,10..12  ; 6535
.shutter 1001100010001 0..1,4..5,9       ; 6536
.shutter 1001100010011 0..1,4..5,9,12    ; 6537
.shutter 1001100010101 0..1,4..5,9,11    ; 6538
.shutter 1001100010111 0..1,4..5,9,11..12 ; 6539
.shutter 1001100011001 0..1,4..5,9..10   ; 6540
.shutter 1001100011011 0..1,4..5,9..10,12 ; 6541
.shutter 1001100011101 0..1,4..5,9..11   ; 6542
.shutter 1001100011111 0..1,4..5,9..12   ; 6543
.shutter 1001100100001 0..1,4..5,8       ; 6544
.shutter 1001100100011 0..1,4..5,8,12    ; 6545
.shutter 1001100100101 0..1,4..5,8,11    ; 6546
.shutter 1001100100111 0..1,4..5,8,11..12 ; 6547
.shutter 1001100101001 0..1,4..5,8,10    ; 6548
.shutter 1001100101011 0..1,4..5,8..12/2 ; 6549
.shutter 1001100101101 0..1,4..5,8,10..11 ; 6550
.shutter 1001100101111 0..1,4..5,8,10..12 ; 6551
.shutter 1001100110001 0..1,4..5,8..9    ; 6552
.shutter 1001100110011 0..1,4..5,8..9,12 ; 6553
.shutter 1001100110101 0..1,4..5,8..9,11 ; 6554
.shutter 1001100110111 0..1,4..5,8..9,11..12 ; 6555
.shutter 1001100111001 0..1,4..5,8..10   ; 6556
.shutter 1001100111011 0..1,4..5,8..10,12 ; 6557
.shutter 1001100111101 0..1,4..5,8..11   ; 6558
.shutter 1001100111111 0..1,4..5,8..12   ; 6559
.shutter 1001101000001 0..1,4..5,7       ; 6560
.shutter 1001101000011 0..1,4..5,7,12    ; 6561
.shutter 1001101000101 0..1,4..5,7,11    ; 6562
.shutter 1001101000111 0..1,4..5,7,11..12 ; 6563
.shutter 1001101001001 0..1,4..5,7,10    ; 6564
.shutter 1001101001011 0..1,4..5,7,10,12 ; 6565
.shutter 1001101001101 0..1,4..5,7,10..11 ; 6566
.shutter 1001101001111 0..1,4..5,7,10..12 ; 6567
.shutter 1001101010001 0..1,4..5,7,9     ; 6568
.shutter 1001101010011 0..1,4..5,7,9,12  ; 6569
.shutter 1001101010101 0..1,4..5,7..11/2 ; 6570
.shutter 1001101010111 0..1,4..5,7..11/2,12 ; 6571
.shutter 1001101011001 0..1,4..5,7,9..10 ; 6572
.shutter 1001101011011 0..1,4..5,7,9..10,12 ; 6573
.shutter 1001101011101 0..1,4..5,7,9..11 ; 6574
.shutter 1001101011111 0..1,4..5,7,9..12 ; 6575
.shutter 1001101100001 0..1,4..5,7..8    ; 6576
.shutter 1001101100011 0..1,4..5,7..8,12 ; 6577
.shutter 1001101100101 0..1,4..5,7..8,11 ; 6578
.shutter 1001101100111 0..1,4..5,7..8,11..12 ; 6579
.shutter 1001101101001 0..1,4..5,7..8,10 ; 6580
.shutter 1001101101011 0..1,4..5,7..8,10,12 ; 6581
.shutter 1001101101101 0..1,4..5,7..8,10..11 ; 6582
.shutter 1001101101111 0..1,4..5,7..8,10..12 ; 6583
.shutter 1001101110001 0..1,4..5,7..9    ; 6584
.shutter 1001101110011 0..1,4..5,7..9,12 ; 6585
.shutter 1001101110101 0..1,4..5,7..9,11 ; 6586
.shutter 1001101110111 0..1,4..5,7..9,11..12 ; 6587
.shutter 1001101111001 0..1,4..5,7..10   ; 6588
.shutter 1001101111011 0..1,4..5,7..10,12 ; 6589
.shutter 1001101111101 0..1,4..5,7..11   ; 6590
.shutter 1001101111111 0..1,4..5,7..12   ; 6591
.shutter 1001110000001 0..1,4..6         ; 6592
.shutter 1001110000011 0..1,4..6,12      ; 6593
.shutter 1001110000101 0..1,4..6,11      ; 6594
.shutter 1001110000111 0..1,4..6,11..12  ; 6595
.shutter 1001110001001 0..1,4..6,10      ; 6596
.shutter 1001110001011 0..1,4..6,10,12   ; 6597
.shutter 1001110001101 0..1,4..6,10..11  ; 6598
.shutter 1001110001111 0..1,4..6,10..12  ; 6599
.shutter 1001110010001 0..1,4..6,9       ; 6600
.shutter 1001110010011 0..1,4..6,9,12    ; 6601
.shutter 1001110010101 0..1,4..6,9,11    ; 6602
.shutter 1001110010111 0..1,4..6,9,11..12 ; 6603
.shutter 1001110011001 0..1,4..6,9..10   ; 6604
.shutter 1001110011011 0..1,4..6,9..10,12 ; 6605
.shutter 1001110011101 0..1,4..6,9..11   ; 6606
.shutter 1001110011111 0..1,4..6,9..12   ; 6607
.shutter 1001110100001 0..1,4..6,8       ; 6608
.shutter 1001110100011 0..1,4..6,8,12    ; 6609
.shutter 1001110100101 0..1,4..6,8,11    ; 6610
.shutter 1001110100111 0..1,4..6,8,11..12 ; 6611
.shutter 1001110101001 0..1,4..6,8,10    ; 6612
.shutter 1001110101011 0..1,4..6,8..12/2 ; 6613
.shutter 1001110101101 0..1,4..6,8,10..11 ; 6614
.shutter 1001110101111 0..1,4..6,8,10..12 ; 6615
.shutter 1001110110001 0..1,4..6,8..9    ; 6616
.shutter 1001110110011 0..1,4..6,8..9,12 ; 6617
.shutter 1001110110101 0..1,4..6,8..9,11 ; 6618
.shutter 1001110110111 0..1,4..6,8..9,11..12 ; 6619
.shutter 1001110111001 0..1,4..6,8..10   ; 6620
.shutter 1001110111011 0..1,4..6,8..10,12 ; 6621
.shutter 1001110111101 0..1,4..6,8..11   ; 6622
.shutter 1001110111111 0..1,4..6,8..12   ; 6623
.shutter 1001111000001 0..1,4..7         ; 6624
.shutter 1001111000011 0..1,4..7,12      ; 6625
.shutter 1001111000101 0..1,4..7,11      ; 6626
.shutter 1001111000111 0..1,4..7,11..12  ; 6627
.shutter 1001111001001 0..1,4..7,10      ; 6628
.shutter 1001111001011 0..1,4..7,10,12   ; 6629
.shutter 1001111001101 0..1,4..7,10..11  ; 6630
.shutter 1001111001111 0..1,4..7,10..12  ; 6631
.shutter 1001111010001 0..1,4..7,9       ; 6632
.shutter 1001111010011 0..1,4..7,9,12    ; 6633
.shutter 1001111010101 0..1,4..7,9,11    ; 6634
.shutter 1001111010111 0..1,4..7,9,11..12 ; 6635
.shutter 1001111011001 0..1,4..7,9..10   ; 6636
.shutter 1001111011011 0..1,4..7,9..10,12 ; 6637
.shutter 1001111011101 0..1,4..7,9..11   ; 6638
.shutter 1001111011111 0..1,4..7,9..12   ; 6639
.shutter 1001111100001 0..1,4..8         ; 6640
.shutter 1001111100011 0..1,4..8,12      ; 6641
.shutter 1001111100101 0..1,4..8,11      ; 6642
.shutter 1001111100111 0..1,4..8,11..12  ; 6643
.shutter 1001111101001 0..1,4..8,10      ; 6644
.shutter 1001111101011 0..1,4..8,10,12   ; 6645
.shutter 1001111101101 0..1,4..8,10..11  ; 6646
.shutter 1001111101111 0..1,4..8,10..12  ; 6647
.shutter 1001111110001 0..1,4..9         ; 6648
.shutter 1001111110011 0..1,4..9,12      ; 6649
.shutter 1001111110101 0..1,4..9,11      ; 6650
.shutter 1001111110111 0..1,4..9,11..12  ; 6651
.shutter 1001111111001 0..1,4..10        ; 6652
.shutter 1001111111011 0..1,4..10,12     ; 6653
.shutter 1001111111101 0..1,4..11        ; 6654
.shutter 1001111111111 0..1,4..12        ; 6655
.shutter 1010000000001 0..1,3            ; 6656
.shutter 1010000000011 0..1,3,12         ; 6657
.shutter 1010000000101 0..1,3,11         ; 6658
.shutter 1010000000111 0..1,3,11..12     ; 6659
.shutter 1010000001001 0..1,3,10         ; 6660
.shutter 1010000001011 0..1,3,10,12      ; 6661
.shutter 1010000001101 0..1,3,10..11     ; 6662
.shutter 1010000001111 0..1,3,10..12     ; 6663
.shutter 1010000010001 0..1,3,9          ; 6664
.shutter 1010000010011 0..1,3,9,12       ; 6665
.shutter 1010000010101 0..1,3,9,11       ; 6666
.shutter 1010000010111 0..1,3,9,11..12   ; 6667
.shutter 1010000011001 0..1,3,9..10      ; 6668
.shutter 1010000011011 0..1,3,9..10,12   ; 6669
.shutter 1010000011101 0..1,3,9..11      ; 6670
.shutter 1010000011111 0..1,3,9..12      ; 6671
.shutter 1010000100001 0..1,3,8          ; 6672
.shutter 1010000100011 0..1,3,8,12       ; 6673
.shutter 1010000100101 0..1,3,8,11       ; 6674
.shutter 1010000100111 0..1,3,8,11..12   ; 6675
.shutter 1010000101001 0..1,3,8,10       ; 6676
.shutter 1010000101011 0..1,3,8..12/2    ; 6677
.shutter 1010000101101 0..1,3,8,10..11   ; 6678
.shutter 1010000101111 0..1,3,8,10..12   ; 6679
.shutter 1010000110001 0..1,3,8..9       ; 6680
.shutter 1010000110011 0..1,3,8..9,12    ; 6681
.shutter 1010000110101 0..1,3,8..9,11    ; 6682
.shutter 1010000110111 0..1,3,8..9,11..12 ; 6683
.shutter 1010000111001 0..1,3,8..10      ; 6684
.shutter 1010000111011 0..1,3,8..10,12   ; 6685
.shutter 1010000111101 0..1,3,8..11      ; 6686
.shutter 1010000111111 0..1,3,8..12      ; 6687
.shutter 1010001000001 0..1,3,7          ; 6688
.shutter 1010001000011 0..1,3,7,12       ; 6689
.shutter 1010001000101 0..1,3,7,11       ; 6690
.shutter 1010001000111 0..1,3,7,11..12   ; 6691
.shutter 1010001001001 0..1,3,7,10       ; 6692
.shutter 1010001001011 0..1,3,7,10,12    ; 6693
.shutter 1010001001101 0..1,3,7,10..11   ; 6694
.shutter 1010001001111 0..1,3,7,10..12   ; 6695
.shutter 1010001010001 0..1,3,7,9        ; 6696
.shutter 1010001010011 0..1,3,7,9,12     ; 6697
.shutter 1010001010101 0..1,3,7..11/2    ; 6698
.shutter 1010001010111 0..1,3,7..11/2,12 ; 6699
.shutter 1010001011001 0..1,3,7,9..10    ; 6700
.shutter 1010001011011 0..1,3,7,9..10,12 ; 6701
.shutter 1010001011101 0..1,3,7,9..11    ; 6702
.shutter 1010001011111 0..1,3,7,9..12    ; 6703
.shutter 1010001100001 0..1,3,7..8       ; 6704
.shutter 1010001100011 0..1,3,7..8,12    ; 6705
.shutter 1010001100101 0..1,3,7..8,11    ; 6706
.shutter 1010001100111 0..1,3,7..8,11..12 ; 6707
.shutter 1010001101001 0..1,3,7..8,10    ; 6708
.shutter 1010001101011 0..1,3,7..8,10,12 ; 6709
.shutter 1010001101101 0..1,3,7..8,10..11 ; 6710
.shutter 1010001101111 0..1,3,7..8,10..12 ; 6711
.shutter 1010001110001 0..1,3,7..9       ; 6712
.shutter 1010001110011 0..1,3,7..9,12    ; 6713
.shutter 1010001110101 0..1,3,7..9,11    ; 6714
.shutter 1010001110111 0..1,3,7..9,11..12 ; 6715
.shutter 1010001111001 0..1,3,7..10      ; 6716
.shutter 1010001111011 0..1,3,7..10,12   ; 6717
.shutter 1010001111101 0..1,3,7..11      ; 6718
.shutter 1010001111111 0..1,3,7..12      ; 6719
.shutter 1010010000001 0..1,3,6          ; 6720
.shutter 1010010000011 0..1,3,6,12       ; 6721
.shutter 1010010000101 0..1,3,6,11       ; 6722
.shutter 1010010000111 0..1,3,6,11..12   ; 6723
.shutter 1010010001001 0..1,3,6,10       ; 6724
.shutter 1010010001011 0..1,3,6,10,12    ; 6725
.shutter 1010010001101 0..1,3,6,10..11   ; 6726
.shutter 1010010001111 0..1,3,6,10..12   ; 6727
.shutter 1010010010001 0..1,3,6,9        ; 6728
.shutter 1010010010011 0..1,3..12/3      ; 6729
.shutter 1010010010101 0..1,3..9/3,11    ; 6730
.shutter 1010010010111 0..1,3..9/3,11..12 ; 6731
.shutter 1010010011001 0..1,3,6,9..10    ; 6732
.shutter 1010010011011 0..1,3..9/3,10,12 ; 6733
.shutter 1010010011101 0..1,3,6,9..11    ; 6734
.shutter 1010010011111 0..1,3,6,9..12    ; 6735
.shutter 1010010100001 0..1,3,6,8        ; 6736
.shutter 1010010100011 0..1,3,6,8,12     ; 6737
.shutter 1010010100101 0..1,3,6,8,11     ; 6738
.shutter 1010010100111 0..1,3,6,8,11..12 ; 6739
.shutter 1010010101001 0..1,3,6..10/2    ; 6740
.shutter 1010010101011 0..1,3,6..12/2    ; 6741
.shutter 1010010101101 0..1,3,6..10/2,11 ; 6742
.shutter 1010010101111 x4b1d             ; 6743
.shutter 1010010110001 0..1,3,6,8..9     ; 6744
.shutter 1010010110011 0..1,3,6,8..9,12  ; 6745
.shutter 1010010110101 0..1,3,6,8..9,11  ; 6746
.shutter 1010010110111 0..1,3,6,8..9,11..12 ; 6747
.shutter 1010010111001 0..1,3,6,8..10    ; 6748
.shutter 1010010111011 0..1,3,6,8..10,12 ; 6749
.shutter 1010010111101 0..1,3,6,8..11    ; 6750
.shutter 1010010111111 0..1,3,6,8..12    ; 6751
.shutter 1010011000001 0..1,3,6..7       ; 6752
.shutter 1010011000011 0..1,3,6..7,12    ; 6753
.shutter 1010011000101 0..1,3,6..7,11    ; 6754
.shutter 1010011000111 0..1,3,6..7,11..12 ; 6755
.shutter 1010011001001 0..1,3,6..7,10    ; 6756
.shutter 1010011001011 0..1,3,6..7,10,12 ; 6757
.shutter 1010011001101 0..1,3,6..7,10..11 ; 6758
.shutter 1010011001111 0..1,3,6..7,10..12 ; 6759
.shutter 1010011010001 0..1,3,6..7,9     ; 6760
.shutter 1010011010011 0..1,3,6..7,9,12  ; 6761
.shutter 1010011010101 0..1,3,6..7,9,11  ; 6762
.shutter 1010011010111 0..1,3,6..7,9,11..12 ; 6763
.shutter 1010011011001 0..1,3,6..7,9..10 ; 6764
.shutter 1010011011011 0..1,3,6..7,9..10,12 ; 6765
.shutter 1010011011101 0..1,3,6..7,9..11 ; 6766
.shutter 1010011011111 0..1,3,6..7,9..12 ; 6767
.shutter 1010011100001 0..1,3,6..8       ; 6768
.shutter 1010011100011 0..1,3,6..8,12    ; 6769
.shutter 1010011100101 0..1,3,6..8,11    ; 6770
.shutter 1010011100111 0..1,3,6..8,11..12 ; 6771
.shutter 1010011101001 0..1,3,6..8,10    ; 6772
.shutter 1010011101011 0..1,3,6..8,10,12 ; 6773
.shutter 1010011101101 0..1,3,6..8,10..11 ; 6774
.shutter 1010011101111 0..1,3,6..8,10..12 ; 6775
.shutter 1010011110001 0..1,3,6..9       ; 6776
.shutter 1010011110011 0..1,3,6..9,12    ; 6777
.shutter 1010011110101 0..1,3,6..9,11    ; 6778
.shutter 1010011110111 0..1,3,6..9,11..12 ; 6779
.shutter 1010011111001 0..1,3,6..10      ; 6780
.shutter 1010011111011 0..1,3,6..10,12   ; 6781
.shutter 1010011111101 0..1,3,6..11      ; 6782
.shutter 1010011111111 0..1,3,6..12      ; 6783
.shutter 1010100000001 0..1,3,5          ; 6784
.shutter 1010100000011 0..1,3,5,12       ; 6785
.shutter 1010100000101 0..1,3,5,11       ; 6786
.shutter 1010100000111 0..1,3,5,11..12   ; 6787
.shutter 1010100001001 0..1,3,5,10       ; 6788
.shutter 1010100001011 0..1,3,5,10,12    ; 6789
.shutter 1010100001101 0..1,3,5,10..11   ; 6790
.shutter 1010100001111 0..1,3,5,10..12   ; 6791
.shutter 1010100010001 0..1,3,5,9        ; 6792
.shutter 1010100010011 0..1,3,5,9,12     ; 6793
.shutter 1010100010101 0..1,3,5,9,11     ; 6794
.shutter 1010100010111 0..1,3,5,9,11..12 ; 6795
.shutter 1010100011001 0..1,3,5,9..10    ; 6796
.shutter 1010100011011 0..1,3,5,9..10,12 ; 6797
.shutter 1010100011101 0..1,3,5,9..11    ; 6798
.shutter 1010100011111 0..1,3,5,9..12    ; 6799
.shutter 1010100100001 0..1,3,5,8        ; 6800
.shutter 1010100100011 0..1,3,5,8,12     ; 6801
.shutter 1010100100101 0..1,3,5..11/3    ; 6802
.shutter 1010100100111 0..1,3,5..11/3,12 ; 6803
.shutter 1010100101001 0..1,3,5,8,10     ; 6804
.shutter 1010100101011 0..1,3,5,8..12/2  ; 6805
.shutter 1010100101101 0..1,3,5,8,10..11 ; 6806
.shutter 1010100101111 0..1,3,5,8,10..12 ; 6807
.shutter 1010100110001 0..1,3,5,8..9     ; 6808
.shutter 1010100110011 0..1,3,5,8..9,12  ; 6809
.shutter 1010100110101 0..1,3,5,8..9,11  ; 6810
.shutter 1010100110111 0..1,3,5,8..9,11..12 ; 6811
.shutter 1010100111001 0..1,3,5,8..10    ; 6812
.shutter 1010100111011 0..1,3,5,8..10,12 ; 6813
.shutter 1010100111101 0..1,3,5,8..11    ; 6814
.shutter 1010100111111 0..1,3,5,8..12    ; 6815
.shutter 1010101000001 0..1,3,5,7        ; 6816
.shutter 1010101000011 0..1,3..7/2,12    ; 6817
.shutter 1010101000101 0..1,3..7/2,11    ; 6818
.shutter 1010101000111 0..1,3..7/2,11..12 ; 6819
.shutter 1010101001001 0..1,3..7/2,10    ; 6820
.shutter 1010101001011 0..1,3..7/2,10,12 ; 6821
.shutter 1010101001101 0..1,3..7/2,10..11 ; 6822
.shutter 1010101001111 0..1,3..7/2,10..12 ; 6823
.shutter 1010101010001 0..1,3..9/2       ; 6824
.shutter 1010101010011 0..1,3..9/2,12    ; 6825
.shutter 1010101010101 0..1,3..11/2      ; 6826
.shutter 1010101010111 0..1,3..11/2,12   ; 6827
.shutter 1010101011001 0..1,3..9/2,10    ; 6828
.shutter 1010101011011 0..1,3..9/2,10,12 ; 6829
.shutter 1010101011101 0..1,3..9/2,10..11 ; 6830
.shutter 1010101011111 0..1,3..9/2,10..12 ; 6831
.shutter 1010101100001 0..1,3,5,7..8     ; 6832
.shutter 1010101100011 0..1,3..7/2,8,12  ; 6833
.shutter 1010101100101 0..1,3..7/2,8,11  ; 6834
.shutter 1010101100111 0..1,3..7/2,8,11..12 ; 6835
.shutter 1010101101001 0..1,3..7/2,8,10  ; 6836
.shutter 1010101101011 0..1,3..7/2,8..12/2 ; 6837
.shutter 1010101101101 0..1,3..7/2,8,10..11 ; 6838
.shutter 1010101101111 0..1,3..7/2,8,10..12 ; 6839
.shutter 1010101110001 0..1,3,5,7..9     ; 6840
.shutter 1010101110011 0..1,3..7/2,8..9,12 ; 6841
.shutter 1010101110101 0..1,3..7/2,8..9,11 ; 6842
.shutter 1010101110111 xab1b             ; 6843
.shutter 1010101111001 0..1,3,5,7..10    ; 6844
.shutter 1010101111011 0..1,3..7/2,8..10,12 ; 6845
.shutter 1010101111101 0..1,3,5,7..11    ; 6846
.shutter 1010101111111 0..1,3,5,7..12    ; 6847
.shutter 1010110000001 0..1,3,5..6       ; 6848
.shutter 1010110000011 0..1,3,5..6,12    ; 6849
.shutter 1010110000101 0..1,3,5..6,11    ; 6850
.shutter 1010110000111 0..1,3,5..6,11..12 ; 6851
.shutter 1010110001001 0..1,3,5..6,10    ; 6852
.shutter 1010110001011 0..1,3,5..6,10,12 ; 6853
.shutter 1010110001101 0..1,3,5..6,10..11 ; 6854
.shutter 1010110001111 0..1,3,5..6,10..12 ; 6855
.shutter 1010110010001 0..1,3,5..6,9     ; 6856
.shutter 1010110010011 0..1,3,5..6,9,12  ; 6857
.shutter 1010110010101 0..1,3,5..6,9,11  ; 6858
.shutter 1010110010111 0..1,3,5..6,9,11..12 ; 6859
.shutter 1010110011001 0..1,3,5..6,9..10 ; 6860
.shutter 1010110011011 0..1,3,5..6,9..10,12 ; 6861
.shutter 1010110011101 0..1,3,5..6,9..11 ; 6862
.shutter 1010110011111 0..1,3,5..6,9..12 ; 6863
.shutter 1010110100001 0..1,3,5..6,8     ; 6864
.shutter 1010110100011 0..1,3,5..6,8,12  ; 6865
.shutter 1010110100101 0..1,3,5..6,8,11  ; 6866
.shutter 1010110100111 0..1,3,5..6,8,11..12 ; 6867
.shutter 1010110101001 0..1,3,5..6,8,10  ; 6868
.shutter 1010110101011 0..1,3,5..6,8..12/2 ; 6869
.shutter 1010110101101 0..1,3,5..6,8,10..11 ; 6870
.shutter 1010110101111 0..1,3,5..6,8,10..12 ; 6871
.shutter 1010110110001 0..1,3,5..6,8..9  ; 6872
.shutter 1010110110011 0..1,3,5..6,8..9,12 ; 6873
.shutter 1010110110101 0..1,3,5..6,8..9,11 ; 6874
.shutter 1010110110111 x6b1b             ; 6875
.shutter 1010110111001 0..1,3,5..6,8..10 ; 6876
.shutter 1010110111011 0..1,3,5..6,8..10,12 ; 6877
.shutter 1010110111101 0..1,3,5..6,8..11 ; 6878
.shutter 1010110111111 0..1,3,5..6,8..12 ; 6879
.shutter 1010111000001 0..1,3,5..7       ; 6880
.shutter 1010111000011 0..1,3,5..7,12    ; 6881
.shutter 1010111000101 0..1,3,5..7,11    ; 6882
.shutter 1010111000111 0..1,3,5..7,11..12 ; 6883
.shutter 1010111001001 0..1,3,5..7,10    ; 6884
.shutter 1010111001011 0..1,3,5..7,10,12 ; 6885
.shutter 1010111001101 0..1,3,5..7,10..11 ; 6886
.shutter 1010111001111 0..1,3,5..7,10..12 ; 6887
.shutter 1010111010001 0..1,3,5..7,9     ; 6888
.shutter 1010111010011 0..1,3,5..7,9,12  ; 6889
.shutter 1010111010101 0..1,3,5..7,9,11  ; 6890
.shutter 1010111010111 0..1,3,5..7,9,11..12 ; 6891
.shutter 1010111011001 0..1,3,5..7,9..10 ; 6892
.shutter 1010111011011 0..1,3,5..7,9..10,12 ; 6893
.shutter 1010111011101 0..1,3,5..7,9..11 ; 6894
.shutter 1010111011111 0..1,3,5..7,9..12 ; 6895
.shutter 1010111100001 0..1,3,5..8       ; 6896
.shutter 1010111100011 0..1,3,5..8,12    ; 6897
.shutter 1010111100101 0..1,3,5..8,11    ; 6898
.shutter 1010111100111 0..1,3,5..8,11..12 ; 6899
.shutter 1010111101001 0..1,3,5..8,10    ; 6900
.shutter 1010111101011 0..1,3,5..8,10,12 ; 6901
.shutter 1010111101101 0..1,3,5..8,10..11 ; 6902
.shutter 1010111101111 0..1,3,5..8,10..12 ; 6903
.shutter 1010111110001 0..1,3,5..9       ; 6904
.shutter 1010111110011 0..1,3,5..9,12    ; 6905
.shutter 1010111110101 0..1,3,5..9,11    ; 6906
.shutter 1010111110111 0..1,3,5..9,11..12 ; 6907
.shutter 1010111111001 0..1,3,5..10      ; 6908
.shutter 1010111111011 0..1,3,5..10,12   ; 6909
.shutter 1010111111101 0..1,3,5..11      ; 6910
.shutter 1010111111111 0..1,3,5..12      ; 6911
.shutter 1011000000001 0..1,3..4         ; 6912
.shutter 1011000000011 0..1,3..4,12      ; 6913
.shutter 1011000000101 0..1,3..4,11      ; 6914
.shutter 1011000000111 0..1,3..4,11..12  ; 6915
.shutter 1011000001001 0..1,3..4,10      ; 6916
.shutter 1011000001011 0..1,3..4,10,12   ; 6917
.shutter 1011000001101 0..1,3..4,10..11  ; 6918
.shutter 1011000001111 0..1,3..4,10..12  ; 6919
.shutter 1011000010001 0..1,3..4,9       ; 6920
.shutter 1011000010011 0..1,3..4,9,12    ; 6921
.shutter 1011000010101 0..1,3..4,9,11    ; 6922
.shutter 1011000010111 0..1,3..4,9,11..12 ; 6923
.shutter 1011000011001 0..1,3..4,9..10   ; 6924
.shutter 1011000011011 0..1,3..4,9..10,12 ; 6925
.shutter 1011000011101 0..1,3..4,9..11   ; 6926
.shutter 1011000011111 0..1,3..4,9..12   ; 6927
.shutter 1011000100001 0..1,3..4,8       ; 6928
.shutter 1011000100011 0..1,3..4,8,12    ; 6929
.shutter 1011000100101 0..1,3..4,8,11    ; 6930
.shutter 1011000100111 0..1,3..4,8,11..12 ; 6931
.shutter 1011000101001 0..1,3..4,8,10    ; 6932
.shutter 1011000101011 0..1,3..4,8..12/2 ; 6933
.shutter 1011000101101 0..1,3..4,8,10..11 ; 6934
.shutter 1011000101111 0..1,3..4,8,10..12 ; 6935
.shutter 1011000110001 0..1,3..4,8..9    ; 6936
.shutter 1011000110011 0..1,3..4,8..9,12 ; 6937
.shutter 1011000110101 0..1,3..4,8..9,11 ; 6938
.shutter 1011000110111 0..1,3..4,8..9,11..12 ; 6939
.shutter 1011000111001 0..1,3..4,8..10   ; 6940
.shutter 1011000111011 0..1,3..4,8..10,12 ; 6941
.shutter 1011000111101 0..1,3..4,8..11   ; 6942
.shutter 1011000111111 0..1,3..4,8..12   ; 6943
.shutter 1011001000001 0..1,3..4,7       ; 6944
.shutter 1011001000011 0..1,3..4,7,12    ; 6945
.shutter 1011001000101 0..1,3..4,7,11    ; 6946
.shutter 1011001000111 0..1,3..4,7,11..12 ; 6947
.shutter 1011001001001 0..1,3..4,7,10    ; 6948
.shutter 1011001001011 0..1,3..4,7,10,12 ; 6949
.shutter 1011001001101 0..1,3..4,7,10..11 ; 6950
.shutter 1011001001111 0..1,3..4,7,10..12 ; 6951
.shutter 1011001010001 0..1,3..4,7,9     ; 6952
.shutter 1011001010011 0..1,3..4,7,9,12  ; 6953
.shutter 1011001010101 0..1,3..4,7..11/2 ; 6954
.shutter 1011001010111 0..1,3..4,7..11/2,12 ; 6955
.shutter 1011001011001 0..1,3..4,7,9..10 ; 6956
.shutter 1011001011011 0..1,3..4,7,9..10,12 ; 6957
.shutter 1011001011101 0..1,3..4,7,9..11 ; 6958
.shutter 1011001011111 0..1,3..4,7,9..12 ; 6959
.shutter 1011001100001 0..1,3..4,7..8    ; 6960
.shutter 1011001100011 0..1,3..4,7..8,12 ; 6961
.shutter 1011001100101 0..1,3..4,7..8,11 ; 6962
.shutter 1011001100111 0..1,3..4,7..8,11..12 ; 6963
.shutter 1011001101001 0..1,3..4,7..8,10 ; 6964
.shutter 1011001101011 0..1,3..4,7..8,10,12 ; 6965
.shutter 1011001101101 0..1,3..4,7..8,10..11 ; 6966
.shutter 1011001101111 0..1,3..4,7..8,10..12 ; 6967
.shutter 1011001110001 0..1,3..4,7..9    ; 6968
.shutter 1011001110011 0..1,3..4,7..9,12 ; 6969
.shutter 1011001110101 0..1,3..4,7..9,11 ; 6970
.shutter 1011001110111 0..1,3..4,7..9,11..12 ; 6971
.shutter 1011001111001 0..1,3..4,7..10   ; 6972
.shutter 1011001111011 0..1,3..4,7..10,12 ; 6973
.shutter 1011001111101 0..1,3..4,7..11   ; 6974
.shutter 1011001111111 0..1,3..4,7..12   ; 6975
.shutter 1011010000001 0..1,3..4,6       ; 6976
.shutter 1011010000011 0..1,3..4,6,12    ; 6977
.shutter 1011010000101 0..1,3..4,6,11    ; 6978
.shutter 1011010000111 0..1,3..4,6,11..12 ; 6979
.shutter 1011010001001 0..1,3..4,6,10    ; 6980
.shutter 1011010001011 0..1,3..4,6,10,12 ; 6981
.shutter 1011010001101 0..1,3..4,6,10..11 ; 6982
.shutter 1011010001111 0..1,3..4,6,10..12 ; 6983
.shutter 1011010010001 0..1,3..4,6,9     ; 6984
.shutter 1011010010011 0..1,3..4,6..12/3 ; 6985
.shutter 1011010010101 0..1,3..4,6,9,11  ; 6986
.shutter 1011010010111 0..1,3..4,6,9,11..12 ; 6987
.shutter 1011010011001 0..1,3..4,6,9..10 ; 6988
.shutter 1011010011011 0..1,3..4,6,9..10,12 ; 6989
.shutter 1011010011101 0..1,3..4,6,9..11 ; 6990
.shutter 1011010011111 0..1,3..4,6,9..12 ; 6991
.shutter 1011010100001 0..1,3..4,6,8     ; 6992
.shutter 1011010100011 0..1,3..4,6,8,12  ; 6993
.shutter 1011010100101 0..1,3..4,6,8,11  ; 6994
.shutter 1011010100111 0..1,3..4,6,8,11..12 ; 6995
.shutter 1011010101001 0..1,3..4,6..10/2 ; 6996
.shutter 1011010101011 0..1,3..4,6..12/2 ; 6997
.shutter 1011010101101 0..1,3..4,6..10/2,11 ; 6998
.shutter 1011010101111 x5b1d             ; 6999
.shutter 1011010110001 0..1,3..4,6,8..9  ; 7000
.shutter 1011010110011 0..1,3..4,6,8..9,12 ; 7001
.shutter 1011010110101 0..1,3..4,6,8..9,11 ; 7002
.shutter 1011010110111 x5b1b             ; 7003
.shutter 1011010111001 0..1,3..4,6,8..10 ; 7004
.shutter 1011010111011 0..1,3..4,6,8..10,12 ; 7005
.shutter 1011010111101 0..1,3..4,6,8..11 ; 7006
.shutter 1011010111111 0..1,3..4,6,8..12 ; 7007
.shutter 1011011000001 0..1,3..4,6..7    ; 7008
.shutter 1011011000011 0..1,3..4,6..7,12 ; 7009
.shutter 1011011000101 0..1,3..4,6..7,11 ; 7010
.shutter 1011011000111 0..1,3..4,6..7,11..12 ; 7011
.shutter 1011011001001 0..1,3..4,6..7,10 ; 7012
.shutter 1011011001011 0..1,3..4,6..7,10,12 ; 7013
.shutter 1011011001101 0..1,3..4,6..7,10..11 ; 7014
.shutter 1011011001111 0..1,3..4,6..7,10..12 ; 7015
.shutter 1011011010001 0..1,3..4,6..7,9  ; 7016
.shutter 1011011010011 0..1,3..4,6..7,9,12 ; 7017
.shutter 1011011010101 0..1,3..4,6..7,9,11 ; 7018
.shutter 1011011010111 xdb1a             ; 7019
.shutter 1011011011001 0..1,3..4,6..7,9..10 ; 7020
.shutter 1011011011011 xdb16             ; 7021
.shutter 1011011011101 0..1,3..4,6..7,9..11 ; 7022
.shutter 1011011011111 0..1,3..4,6..7,9..12 ; 7023
.shutter 1011011100001 0..1,3..4,6..8    ; 7024
.shutter 1011011100011 0..1,3..4,6..8,12 ; 7025
.shutter 1011011100101 0..1,3..4,6..8,11 ; 7026
.shutter 1011011100111 0..1,3..4,6..8,11..12 ; 7027
.shutter 1011011101001 0..1,3..4,6..8,10 ; 7028
.shutter 1011011101011 0..1,3..4,6..8,10,12 ; 7029
.shutter 1011011101101 0..1,3..4,6..8,10..11 ; 7030
.shutter 1011011101111 0..1,3..4,6..8,10..12 ; 7031
.shutter 1011011110001 0..1,3..4,6..9    ; 7032
.shutter 1011011110011 0..1,3..4,6..9,12 ; 7033
.shutter 1011011110101 0..1,3..4,6..9,11 ; 7034
.shutter 1011011110111 0..1,3..4,6..9,11..12 ; 7035
.shutter 1011011111001 0..1,3..4,6..10   ; 7036
.shutter 1011011111011 0..1,3..4,6..10,12 ; 7037
.shutter 1011011111101 0..1,3..4,6..11   ; 7038
.shutter 1011011111111 0..1,3..4,6..12   ; 7039
.shutter 1011100000001 0..1,3..5         ; 7040
.shutter 1011100000011 0..1,3..5,12      ; 7041
.shutter 1011100000101 0..1,3..5,11      ; 7042
.shutter 1011100000111 0..1,3..5,11..12  ; 7043
.shutter 1011100001001 0..1,3..5,10      ; 7044
.shutter 1011100001011 0..1,3..5,10,12   ; 7045
.shutter 1011100001101 0..1,3..5,10..11  ; 7046
.shutter 1011100001111 0..1,3..5,10..12  ; 7047
.shutter 1011100010001 0..1,3..5,9       ; 7048
.shutter 1011100010011 0..1,3..5,9,12    ; 7049
.shutter 1011100010101 0..1,3..5,9,11    ; 7050
.shutter 1011100010111 0..1,3..5,9,11..12 ; 7051
.shutter 1011100011001 0..1,3..5,9..10   ; 7052
.shutter 1011100011011 0..1,3..5,9..10,12 ; 7053
.shutter 1011100011101 0..1,3..5,9..11   ; 7054
.shutter 1011100011111 0..1,3..5,9..12   ; 7055
.shutter 1011100100001 0..1,3..5,8       ; 7056
.shutter 1011100100011 0..1,3..5,8,12    ; 7057
.shutter 1011100100101 0..1,3..5,8,11    ; 7058
.shutter 1011100100111 0..1,3..5,8,11..12 ; 7059
.shutter 1011100101001 0..1,3..5,8,10    ; 7060
.shutter 1011100101011 0..1,3..5,8..12/2 ; 7061
.shutter 1011100101101 0..1,3..5,8,10..11 ; 7062
.shutter 1011100101111 0..1,3..5,8,10..12 ; 7063
.shutter 1011100110001 0..1,3..5,8..9    ; 7064
.shutter 1011100110011 0..1,3..5,8..9,12 ; 7065
.shutter 1011100110101 0..1,3..5,8..9,11 ; 7066
.shutter 1011100110111 0..1,3..5,8..9,11..12 ; 7067
.shutter 1011100111001 0..1,3..5,8..10   ; 7068
.shutter 1011100111011 0..1,3..5,8..10,12 ; 7069
.shutter 1011100111101 0..1,3..5,8..11   ; 7070
.shutter 1011100111111 0..1,3..5,8..12   ; 7071
.shutter 1011101000001 0..1,3..5,7       ; 7072
.shutter 1011101000011 0..1,3..5,7,12    ; 7073
.shutter 1011101000101 0..1,3..5,7,11    ; 7074
.shutter 1011101000111 0..1,3..5,7,11..12 ; 7075
.shutter 1011101001001 0..1,3..5,7,10    ; 7076
.shutter 1011101001011 0..1,3..5,7,10,12 ; 7077
.shutter 1011101001101 0..1,3..5,7,10..11 ; 7078
.shutter 1011101001111 0..1,3..5,7,10..12 ; 7079
.shutter 1011101010001 0..1,3..5,7,9     ; 7080
.shutter 1011101010011 0..1,3..5,7,9,12  ; 7081
.shutter 1011101010101 0..1,3..5,7..11/2 ; 7082
.shutter 1011101010111 0..1,3..5,7..11/2,12 ; 7083
.shutter 1011101011001 0..1,3..5,7,9..10 ; 7084
.shutter 1011101011011 0..1,3..5,7,9..10,12 ; 7085
.shutter 1011101011101 0..1,3..5,7,9..11 ; 7086
.shutter 1011101011111 0..1,3..5,7,9..12 ; 7087
.shutter 1011101100001 0..1,3..5,7..8    ; 7088
.shutter 1011101100011 0..1,3..5,7..8,12 ; 7089
.shutter 1011101100101 0..1,3..5,7..8,11 ; 7090
.shutter 1011101100111 0..1,3..5,7..8,11..12 ; 7091
.shutter 1011101101001 0..1,3..5,7..8,10 ; 7092
.shutter 1011101101011 0..1,3..5,7..8,10,12 ; 7093
.shutter 1011101101101 0..1,3..5,7..8,10..11 ; 7094
.shutter 1011101101111 0..1,3..5,7..8,10..12 ; 7095
.shutter 1011101110001 0..1,3..5,7..9    ; 7096
.shutter 1011101110011 0..1,3..5,7..9,12 ; 7097
.shutter 1011101110101 0..1,3..5,7..9,11 ; 7098
.shutter 1011101110111 0..1,3..5,7..9,11..12 ; 7099
.shutter 1011101111001 0..1,3..5,7..10   ; 7100
.shutter 1011101111011 0..1,3..5,7..10,12 ; 7101
.shutter 1011101111101 0..1,3..5,7..11   ; 7102
.shutter 1011101111111 0..1,3..5,7..12   ; 7103
.shutter 1011110000001 0..1,3..6         ; 7104
.shutter 1011110000011 0..1,3..6,12      ; 7105
.shutter 1011110000101 0..1,3..6,11      ; 7106
.shutter 1011110000111 0..1,3..6,11..12  ; 7107
.shutter 1011110001001 0..1,3..6,10      ; 7108
.shutter 1011110001011 0..1,3..6,10,12   ; 7109
.shutter 1011110001101 0..1,3..6,10..11  ; 7110
.shutter 1011110001111 0..1,3..6,10..12  ; 7111
.shutter 1011110010001 0..1,3..6,9       ; 7112
.shutter 1011110010011 0..1,3..6,9,12    ; 7113
.shutter 1011110010101 0..1,3..6,9,11    ; 7114
.shutter 1011110010111 0..1,3..6,9,11..12 ; 7115
.shutter 1011110011001 0..1,3..6,9..10   ; 7116
.shutter 1011110011011 0..1,3..6,9..10,12 ; 7117
.shutter 1011110011101 0..1,3..6,9..11   ; 7118
.shutter 1011110011111 0..1,3..6,9..12   ; 7119
.shutter 1011110100001 0..1,3..6,8       ; 7120
.shutter 1011110100011 0..1,3..6,8,12    ; 7121
.shutter 1011110100101 0..1,3..6,8,11    ; 7122
.shutter 1011110100111 0..1,3..6,8,11..12 ; 7123
.shutter 1011110101001 0..1,3..6,8,10    ; 7124
.shutter 1011110101011 0..1,3..6,8..12/2 ; 7125
.shutter 1011110101101 0..1,3..6,8,10..11 ; 7126
.shutter 1011110101111 0..1,3..6,8,10..12 ; 7127
.shutter 1011110110001 0..1,3..6,8..9    ; 7128
.shutter 1011110110011 0..1,3..6,8..9,12 ; 7129
.shutter 1011110110101 0..1,3..6,8..9,11 ; 7130
.shutter 1011110110111 0..1,3..6,8..9,11..12 ; 7131
.shutter 1011110111001 0..1,3..6,8..10   ; 7132
.shutter 1011110111011 0..1,3..6,8..10,12 ; 7133
.shutter 1011110111101 0..1,3..6,8..11   ; 7134
.shutter 1011110111111 0..1,3..6,8..12   ; 7135
.shutter 1011111000001 0..1,3..7         ; 7136
.shutter 1011111000011 0..1,3..7,12      ; 7137
.shutter 1011111000101 0..1,3..7,11      ; 7138
.shutter 1011111000111 0..1,3..7,11..12  ; 7139
.shutter 1011111001001 0..1,3..7,10      ; 7140
.shutter 1011111001011 0..1,3..7,10,12   ; 7141
.shutter 1011111001101 0..1,3..7,10..11  ; 7142
.shutter 1011111001111 0..1,3..7,10..12  ; 7143
.shutter 1011111010001 0..1,3..7,9       ; 7144
.shutter 1011111010011 0..1,3..7,9,12    ; 7145
.shutter 1011111010101 0..1,3..7,9,11    ; 7146
.shutter 1011111010111 0..1,3..7,9,11..12 ; 7147
.shutter 1011111011001 0..1,3..7,9..10   ; 7148
.shutter 1011111011011 0..1,3..7,9..10,12 ; 7149
.shutter 1011111011101 0..1,3..7,9..11   ; 7150
.shutter 1011111011111 0..1,3..7,9..12   ; 7151
.shutter 1011111100001 0..1,3..8         ; 7152
.shutter 1011111100011 0..1,3..8,12      ; 7153
.shutter 1011111100101 0..1,3..8,11      ; 7154
.shutter 1011111100111 0..1,3..8,11..12  ; 7155
.shutter 1011111101001 0..1,3..8,10      ; 7156
.shutter 1011111101011 0..1,3..8,10,12   ; 7157
.shutter 1011111101101 0..1,3..8,10..11  ; 7158
.shutter 1011111101111 0..1,3..8,10..12  ; 7159
.shutter 1011111110001 0..1,3..9         ; 7160
.shutter 1011111110011 0..1,3..9,12      ; 7161
.shutter 1011111110101 0..1,3..9,11      ; 7162
.shutter 1011111110111 0..1,3..9,11..12  ; 7163
.shutter 1011111111001 0..1,3..10        ; 7164
.shutter 1011111111011 0..1,3..10,12     ; 7165
.shutter 1011111111101 0..1,3..11        ; 7166
.shutter 1011111111111 0..1,3..12        ; 7167
.shutter 1100000000001 0..2              ; 7168
.shutter 1100000000011 0..2,12           ; 7169
.shutter 1100000000101 0..2,11           ; 7170
.shutter 1100000000111 0..2,11..12       ; 7171
.shutter 1100000001001 0..2,10           ; 7172
.shutter 1100000001011 0..2,10,12        ; 7173
.shutter 1100000001101 0..2,10..11       ; 7174
.shutter 1100000001111 0..2,10..12       ; 7175
.shutter 1100000010001 0..2,9            ; 7176
.shutter 1100000010011 0..2,9,12         ; 7177
.shutter 1100000010101 0..2,9,11         ; 7178
.shutter 1100000010111 0..2,9,11..12     ; 7179
.shutter 1100000011001 0..2,9..10        ; 7180
.shutter 1100000011011 0..2,9..10,12     ; 7181
.shutter 1100000011101 0..2,9..11        ; 7182
.shutter 1100000011111 0..2,9..12        ; 7183
.shutter 1100000100001 0..2,8            ; 7184
.shutter 1100000100011 0..2,8,12         ; 7185
.shutter 1100000100101 0..2,8,11         ; 7186
.shutter 1100000100111 0..2,8,11..12     ; 7187
.shutter 1100000101001 0..2,8,10         ; 7188
.shutter 1100000101011 0..2,8,10,12      ; 7189
.shutter 1100000101101 0..2,8,10..11     ; 7190
.shutter 1100000101111 0..2,8,10..12     ; 7191
.shutter 1100000110001 0..2,8..9         ; 7192
.shutter 1100000110011 0..2,8..9,12      ; 7193
.shutter 1100000110101 0..2,8..9,11      ; 7194
.shutter 1100000110111 0..2,8..9,11..12  ; 7195
.shutter 1100000111001 0..2,8..10        ; 7196
.shutter 1100000111011 0..2,8..10,12     ; 7197
.shutter 1100000111101 0..2,8..11        ; 7198
.shutter 1100000111111 0..2,8..12        ; 7199
.shutter 1100001000001 0..2,7            ; 7200
.shutter 1100001000011 0..2,7,12         ; 7201
.shutter 1100001000101 0..2,7,11         ; 7202
.shutter 1100001000111 0..2,7,11..12     ; 7203
.shutter 1100001001001 0..2,7,10         ; 7204
.shutter 1100001001011 0..2,7,10,12      ; 7205
.shutter 1100001001101 0..2,7,10..11     ; 7206
.shutter 1100001001111 0..2,7,10..12     ; 7207
.shutter 1100001010001 0..2,7,9          ; 7208
.shutter 1100001010011 0..2,7,9,12       ; 7209
.shutter 1100001010101 0..2,7,9,11       ; 7210
.shutter 1100001010111 0..2,7,9,11..12   ; 7211
.shutter 1100001011001 0..2,7,9..10      ; 7212
.shutter 1100001011011 0..2,7,9..10,12   ; 7213
.shutter 1100001011101 0..2,7,9..11      ; 7214
.shutter 1100001011111 0..2,7,9..12      ; 7215
.shutter 1100001100001 0..2,7..8         ; 7216
.shutter 1100001100011 0..2,7..8,12      ; 7217
.shutter 1100001100101 0..2,7..8,11      ; 7218
.shutter 1100001100111 0..2,7..8,11..12  ; 7219
.shutter 1100001101001 0..2,7..8,10      ; 7220
.shutter 1100001101011 0..2,7..8,10,12   ; 7221
.shutter 1100001101101 0..2,7..8,10..11  ; 7222
.shutter 1100001101111 0..2,7..8,10..12  ; 7223
.shutter 1100001110001 0..2,7..9         ; 7224
.shutter 1100001110011 0..2,7..9,12      ; 7225
.shutter 1100001110101 0..2,7..9,11      ; 7226
.shutter 1100001110111 0..2,7..9,11..12  ; 7227
.shutter 1100001111001 0..2,7..10        ; 7228
.shutter 1100001111011 0..2,7..10,12     ; 7229
.shutter 1100001111101 0..2,7..11        ; 7230
.shutter 1100001111111 0..2,7..12        ; 7231
.shutter 1100010000001 0..2,6            ; 7232
.shutter 1100010000011 0..2,6,12         ; 7233
.shutter 1100010000101 0..2,6,11         ; 7234
.shutter 1100010000111 0..2,6,11..12     ; 7235
.shutter 1100010001001 0..2,6,10         ; 7236
.shutter 1100010001011 0..2,6,10,12      ; 7237
.shutter 1100010001101 0..2,6,10..11     ; 7238
.shutter 1100010001111 0..2,6,10..12     ; 7239
.shutter 1100010010001 0..2,6,9          ; 7240
.shutter 1100010010011 0..2,6,9,12       ; 7241
.shutter 1100010010101 0..2,6,9,11       ; 7242
.shutter 1100010010111 0..2,6,9,11..12   ; 7243
.shutter 1100010011001 0..2,6,9..10      ; 7244
.shutter 1100010011011 0..2,6,9..10,12   ; 7245
.shutter 1100010011101 0..2,6,9..11      ; 7246
.shutter 1100010011111 0..2,6,9..12      ; 7247
.shutter 1100010100001 0..2,6,8          ; 7248
.shutter 1100010100011 0..2,6,8,12       ; 7249
.shutter 1100010100101 0..2,6,8,11       ; 7250
.shutter 1100010100111 0..2,6,8,11..12   ; 7251
.shutter 1100010101001 0..2,6,8,10       ; 7252
.shutter 1100010101011 0..2,6..12/2      ; 7253
.shutter 1100010101101 0..2,6,8,10..11   ; 7254
.shutter 1100010101111 0..2,6,8,10..12   ; 7255
.shutter 1100010110001 0..2,6,8..9       ; 7256
.shutter 1100010110011 0..2,6,8..9,12    ; 7257
.shutter 1100010110101 0..2,6,8..9,11    ; 7258
.shutter 1100010110111 0..2,6,8..9,11..12 ; 7259
.shutter 1100010111001 0..2,6,8..10      ; 7260
.shutter 1100010111011 0..2,6,8..10,12   ; 7261
.shutter 1100010111101 0..2,6,8..11      ; 7262
.shutter 1100010111111 0..2,6,8..12      ; 7263
.shutter 1100011000001 0..2,6..7         ; 7264
.shutter 1100011000011 0..2,6..7,12      ; 7265
.shutter 1100011000101 0..2,6..7,11      ; 7266
.shutter 1100011000111 0..2,6..7,11..12  ; 7267
.shutter 1100011001001 0..2,6..7,10      ; 7268
.shutter 1100011001011 0..2,6..7,10,12   ; 7269
.shutter 1100011001101 0..2,6..7,10..11  ; 7270
.shutter 1100011001111 0..2,6..7,10..12  ; 7271
.shutter 1100011010001 0..2,6..7,9       ; 7272
.shutter 1100011010011 0..2,6..7,9,12    ; 7273
.shutter 1100011010101 0..2,6..7,9,11    ; 7274
.shutter 1100011010111 0..2,6..7,9,11..12 ; 7275
.shutter 1100011011001 0..2,6..7,9..10   ; 7276
.shutter 1100011011011 0..2,6..7,9..10,12 ; 7277
.shutter 1100011011101 0..2,6..7,9..11   ; 7278
.shutter 1100011011111 0..2,6..7,9..12   ; 7279
.shutter 1100011100001 0..2,6..8         ; 7280
.shutter 1100011100011 0..2,6..8,12      ; 7281
.shutter 1100011100101 0..2,6..8,11      ; 7282
.shutter 1100011100111 0..2,6..8,11..12  ; 7283
.shutter 1100011101001 0..2,6..8,10      ; 7284
.shutter 1100011101011 0..2,6..8,10,12   ; 7285
.shutter 1100011101101 0..2,6..8,10..11  ; 7286
.shutter 1100011101111 0..2,6..8,10..12  ; 7287
.shutter 1100011110001 0..2,6..9         ; 7288
.shutter 1100011110011 0..2,6..9,12      ; 7289
.shutter 1100011110101 0..2,6..9,11      ; 7290
.shutter 1100011110111 0..2,6..9,11..12  ; 7291
.shutter 1100011111001 0..2,6..10        ; 7292
.shutter 1100011111011 0..2,6..10,12     ; 7293
.shutter 1100011111101 0..2,6..11        ; 7294
.shutter 1100011111111 0..2,6..12        ; 7295
.shutter 1100100000001 0..2,5            ; 7296
.shutter 1100100000011 0..2,5,12         ; 7297
.shutter 1100100000101 0..2,5,11         ; 7298
.shutter 1100100000111 0..2,5,11..12     ; 7299
.shutter 1100100001001 0..2,5,10         ; 7300
.shutter 1100100001011 0..2,5,10,12      ; 7301
.shutter 1100100001101 0..2,5,10..11     ; 7302
.shutter 1100100001111 0..2,5,10..12     ; 7303
.shutter 1100100010001 0..2,5,9          ; 7304
.shutter 1100100010011 0..2,5,9,12       ; 7305
.shutter 1100100010101 0..2,5,9,11       ; 7306
.shutter 1100100010111 0..2,5,9,11..12   ; 7307
.shutter 1100100011001 0..2,5,9..10      ; 7308
.shutter 1100100011011 0..2,5,9..10,12   ; 7309
.shutter 1100100011101 0..2,5,9..11      ; 7310
.shutter 1100100011111 0..2,5,9..12      ; 7311
.shutter 1100100100001 0..2,5,8          ; 7312
.shutter 1100100100011 0..2,5,8,12       ; 7313
.shutter 1100100100101 0..2,5,8,11       ; 7314
.shutter 1100100100111 0..2,5,8,11..12   ; 7315
.shutter 1100100101001 0..2,5,8,10       ; 7316
.shutter 1100100101011 0..2,5,8..12/2    ; 7317
.shutter 1100100101101 0..2,5,8,10..11   ; 7318
.shutter 1100100101111 0..2,5,8,10..12   ; 7319
.shutter 1100100110001 0..2,5,8..9       ; 7320
.shutter 1100100110011 0..2,5,8..9,12    ; 7321
.shutter 1100100110101 0..2,5,8..9,11    ; 7322
.shutter 1100100110111 0..2,5,8..9,11..12 ; 7323
.shutter 1100100111001 0..2,5,8..10      ; 7324
.shutter 1100100111011 0..2,5,8..10,12   ; 7325
.shutter 1100100111101 0..2,5,8..11      ; 7326
.shutter 1100100111111 0..2,5,8..12      ; 7327
.shutter 1100101000001 0..2,5,7          ; 7328
.shutter 1100101000011 0..2,5,7,12       ; 7329
.shutter 1100101000101 0..2,5,7,11       ; 7330
.shutter 1100101000111 0..2,5,7,11..12   ; 7331
.shutter 1100101001001 0..2,5,7,10       ; 7332
.shutter 1100101001011 0..2,5,7,10,12    ; 7333
.shutter 1100101001101 0..2,5,7,10..11   ; 7334
.shutter 1100101001111 0..2,5,7,10..12   ; 7335
.shutter 1100101010001 0..2,5,7,9        ; 7336
.shutter 1100101010011 0..2,5..9/2,12    ; 7337
.shutter 1100101010101 0..2,5..11/2      ; 7338
.shutter 1100101010111 0..2,5..11/2,12   ; 7339
.shutter 1100101011001 0..2,5,7,9..10    ; 7340
.shutter 1100101011011 0..2,5..9/2,10,12 ; 7341
.shutter 1100101011101 0..2,5,7,9..11    ; 7342
.shutter 1100101011111 0..2,5,7,9..12    ; 7343
.shutter 1100101100001 0..2,5,7..8       ; 7344
.shutter 1100101100011 0..2,5,7..8,12    ; 7345
.shutter 1100101100101 0..2,5,7..8,11    ; 7346
.shutter 1100101100111 0..2,5,7..8,11..12 ; 7347
.shutter 1100101101001 0..2,5,7..8,10    ; 7348
.shutter 1100101101011 0..2,5,7..8,10,12 ; 7349
.shutter 1100101101101 0..2,5,7..8,10..11 ; 7350
.shutter 1100101101111 0..2,5,7..8,10..12 ; 7351
.shutter 1100101110001 0..2,5,7..9       ; 7352
.shutter 1100101110011 0..2,5,7..9,12    ; 7353
.shutter 1100101110101 0..2,5,7..9,11    ; 7354
.shutter 1100101110111 0..2,5,7..9,11..12 ; 7355
.shutter 1100101111001 0..2,5,7..10      ; 7356
.shutter 1100101111011 0..2,5,7..10,12   ; 7357
.shutter 1100101111101 0..2,5,7..11      ; 7358
.shutter 1100101111111 0..2,5,7..12      ; 7359
.shutter 1100110000001 0..2,5..6         ; 7360
.shutter 1100110000011 0..2,5..6,12      ; 7361
.shutter 1100110000101 0..2,5..6,11      ; 7362
.shutter 1100110000111 0..2,5..6,11..12  ; 7363
.shutter 1100110001001 0..2,5..6,10      ; 7364
.shutter 1100110001011 0..2,5..6,10,12   ; 7365
.shutter 1100110001101 0..2,5..6,10..11  ; 7366
.shutter 1100110001111 0..2,5..6,10..12  ; 7367
.shutter 1100110010001 0..2,5..6,9       ; 7368
.shutter 1100110010011 0..2,5..6,9,12    ; 7369
.shutter 1100110010101 0..2,5..6,9,11    ; 7370
.shutter 1100110010111 0..2,5..6,9,11..12 ; 7371
.shutter 1100110011001 0..2,5..6,9..10   ; 7372
.shutter 1100110011011 0..2,5..6,9..10,12 ; 7373
.shutter 1100110011101 0..2,5..6,9..11   ; 7374
.shutter 1100110011111 0..2,5..6,9..12   ; 7375
.shutter 1100110100001 0..2,5..6,8       ; 7376
.shutter 1100110100011 0..2,5..6,8,12    ; 7377
.shutter 1100110100101 0..2,5..6,8,11    ; 7378
.shutter 1100110100111 0..2,5..6,8,11..12 ; 7379
.shutter 1100110101001 0..2,5..6,8,10    ; 7380
.shutter 1100110101011 0..2,5..6,8..12/2 ; 7381
.shutter 1100110101101 0..2,5..6,8,10..11 ; 7382
.shutter 1100110101111 0..2,5..6,8,10..12 ; 7383
.shutter 1100110110001 0..2,5..6,8..9    ; 7384
.shutter 1100110110011 0..2,5..6,8..9,12 ; 7385
.shutter 1100110110101 0..2,5..6,8..9,11 ; 7386
.shutter 1100110110111 0..2,5..6,8..9,11..12 ; 7387
.shutter 1100110111001 0..2,5..6,8..10   ; 7388
.shutter 1100110111011 0..2,5..6,8..10,12 ; 7389
.shutter 1100110111101 0..2,5..6,8..11   ; 7390
.shutter 1100110111111 0..2,5..6,8..12   ; 7391
.shutter 1100111000001 0..2,5..7         ; 7392
.shutter 1100111000011 0..2,5..7,12      ; 7393
.shutter 1100111000101 0..2,5..7,11      ; 7394
.shutter 1100111000111 0..2,5..7,11..12  ; 7395
.shutter 1100111001001 0..2,5..7,10      ; 7396
.shutter 1100111001011 0..2,5..7,10,12   ; 7397
.shutter 1100111001101 0..2,5..7,10..11  ; 7398
.shutter 1100111001111 0..2,5..7,10..12  ; 7399
.shutter 1100111010001 0..2,5..7,9       ; 7400
.shutter 1100111010011 0..2,5..7,9,12    ; 7401
.shutter 1100111010101 0..2,5..7,9,11    ; 7402
.shutter 1100111010111 0..2,5..7,9,11..12 ; 7403
.shutter 1100111011001 0..2,5..7,9..10   ; 7404
.shutter 1100111011011 0..2,5..7,9..10,12 ; 7405
.shutter 1100111011101 0..2,5..7,9..11   ; 7406
.shutter 1100111011111 0..2,5..7,9..12   ; 7407
.shutter 1100111100001 0..2,5..8         ; 7408
.shutter 1100111100011 0..2,5..8,12      ; 7409
.shutter 1100111100101 0..2,5..8,11      ; 7410
.shutter 1100111100111 0..2,5..8,11..12  ; 7411
.shutter 1100111101001 0..2,5..8,10      ; 7412
.shutter 1100111101011 0..2,5..8,10,12   ; 7413
.shutter 1100111101101 0..2,5..8,10..11  ; 7414
.shutter 1100111101111 0..2,5..8,10..12  ; 7415
.shutter 1100111110001 0..2,5..9         ; 7416
.shutter 1100111110011 0..2,5..9,12      ; 7417
.shutter 1100111110101 0..2,5..9,11      ; 7418
.shutter 1100111110111 0..2,5..9,11..12  ; 7419
.shutter 1100111111001 0..2,5..10        ; 7420
.shutter 1100111111011 0..2,5..10,12     ; 7421
.shutter 1100111111101 0..2,5..11        ; 7422
.shutter 1100111111111 0..2,5..12        ; 7423
.shutter 1101000000001 0..2,4            ; 7424
.shutter 1101000000011 0..2,4,12         ; 7425
.shutter 1101000000101 0..2,4,11         ; 7426
.shutter 1101000000111 0..2,4,11..12     ; 7427
.shutter 1101000001001 0..2,4,10         ; 7428
.shutter 1101000001011 0..2,4,10,12      ; 7429
.shutter 1101000001101 0..2,4,10..11     ; 7430
.shutter 1101000001111 0..2,4,10..12     ; 7431
.shutter 1101000010001 0..2,4,9          ; 7432
.shutter 1101000010011 0..2,4,9,12       ; 7433
.shutter 1101000010101 0..2,4,9,11       ; 7434
.shutter 1101000010111 0..2,4,9,11..12   ; 7435
.shutter 1101000011001 0..2,4,9..10      ; 7436
.shutter 1101000011011 0..2,4,9..10,12   ; 7437
.shutter 1101000011101 0..2,4,9..11      ; 7438
.shutter 1101000011111 0..2,4,9..12      ; 7439
.shutter 1101000100001 0..2,4,8          ; 7440
.shutter 1101000100011 0..2,4,8,12       ; 7441
.shutter 1101000100101 0..2,4,8,11       ; 7442
.shutter 1101000100111 0..2,4,8,11..12   ; 7443
.shutter 1101000101001 0..2,4,8,10       ; 7444
.shutter 1101000101011 0..2,4,8..12/2    ; 7445
.shutter 1101000101101 0..2,4,8,10..11   ; 7446
.shutter 1101000101111 0..2,4,8,10..12   ; 7447
.shutter 1101000110001 0..2,4,8..9       ; 7448
.shutter 1101000110011 0..2,4,8..9,12    ; 7449
.shutter 1101000110101 0..2,4,8..9,11    ; 7450
.shutter 1101000110111 0..2,4,8..9,11..12 ; 7451
.shutter 1101000111001 0..2,4,8..10      ; 7452
.shutter 1101000111011 0..2,4,8..10,12   ; 7453
.shutter 1101000111101 0..2,4,8..11      ; 7454
.shutter 1101000111111 0..2,4,8..12      ; 7455
.shutter 1101001000001 0..2,4,7          ; 7456
.shutter 1101001000011 0..2,4,7,12       ; 7457
.shutter 1101001000101 0..2,4,7,11       ; 7458
.shutter 1101001000111 0..2,4,7,11..12   ; 7459
.shutter 1101001001001 0..2,4,7,10       ; 7460
.shutter 1101001001011 0..2,4..10/3,12   ; 7461
.shutter 1101001001101 0..2,4,7,10..11   ; 7462
.shutter 1101001001111 0..2,4,7,10..12   ; 7463
.shutter 1101001010001 0..2,4,7,9        ; 7464
.shutter 1101001010011 0..2,4,7,9,12     ; 7465
.shutter 1101001010101 0..2,4,7..11/2    ; 7466
.shutter 1101001010111 0..2,4,7..11/2,12 ; 7467
.shutter 1101001011001 0..2,4,7,9..10    ; 7468
.shutter 1101001011011 0..2,4,7,9..10,12 ; 7469
.shutter 1101001011101 0..2,4,7,9..11    ; 7470
.shutter 1101001011111 0..2,4,7,9..12    ; 7471
.shutter 1101001100001 0..2,4,7..8       ; 7472
.shutter 1101001100011 0..2,4,7..8,12    ; 7473
.shutter 1101001100101 0..2,4,7..8,11    ; 7474
.shutter 1101001100111 0..2,4,7..8,11..12 ; 7475
.shutter 1101001101001 0..2,4,7..8,10    ; 7476
.shutter 1101001101011 0..2,4,7..8,10,12 ; 7477
.shutter 1101001101101 0..2,4,7..8,10..11 ; 7478
.shutter 1101001101111 0..2,4,7..8,10..12 ; 7479
.shutter 1101001110001 0..2,4,7..9       ; 7480
.shutter 1101001110011 0..2,4,7..9,12    ; 7481
.shutter 1101001110101 0..2,4,7..9,11    ; 7482
.shutter 1101001110111 0..2,4,7..9,11..12 ; 7483
.shutter 1101001111001 0..2,4,7..10      ; 7484
.shutter 1101001111011 0..2,4,7..10,12   ; 7485
.shutter 1101001111101 0..2,4,7..11      ; 7486
.shutter 1101001111111 0..2,4,7..12      ; 7487
.shutter 1101010000001 0..2,4,6          ; 7488
.shutter 1101010000011 0..2,4,6,12       ; 7489
.shutter 1101010000101 0..2,4,6,11       ; 7490
.shutter 1101010000111 0..2,4,6,11..12   ; 7491
.shutter 1101010001001 0..2,4,6,10       ; 7492
.shutter 1101010001011 0..2,4,6,10,12    ; 7493
.shutter 1101010001101 0..2,4,6,10..11   ; 7494
.shutter 1101010001111 0..2,4,6,10..12   ; 7495
.shutter 1101010010001 0..2,4,6,9        ; 7496
.shutter 1101010010011 0..2,4,6..12/3    ; 7497
.shutter 1101010010101 0..2,4,6,9,11     ; 7498
.shutter 1101010010111 0..2,4,6,9,11..12 ; 7499
.shutter 1101010011001 0..2,4,6,9..10    ; 7500
.shutter 1101010011011 0..2,4,6,9..10,12 ; 7501
.shutter 1101010011101 0..2,4,6,9..11    ; 7502
.shutter 1101010011111 0..2,4,6,9..12    ; 7503
.shutter 1101010100001 0..2,4,6,8        ; 7504
.shutter 1101010100011 0..2,4..8/2,12    ; 7505
.shutter 1101010100101 0..2,4..8/2,11    ; 7506
.shutter 1101010100111 0..2,4..8/2,11..12 ; 7507
.shutter 1101010101001 0..2,4..10/2      ; 7508
.shutter 1101010101011 0..2,4..12/2      ; 7509
.shutter 1101010101101 0..2,4..10/2,11   ; 7510
.shutter 1101010101111 0..2,4..10/2,11..12 ; 7511
.shutter 1101010110001 0..2,4,6,8..9     ; 7512
.shutter 1101010110011 0..2,4..8/2,9,12  ; 7513
.shutter 1101010110101 0..2,4..8/2,9,11  ; 7514
.shutter 1101010110111 0..2,4..8/2,9,11..12 ; 7515
.shutter 1101010111001 0..2,4,6,8..10    ; 7516
.shutter 1101010111011 0..2,4..8/2,9..10,12 ; 7517
.shutter 1101010111101 0..2,4,6,8..11    ; 7518
.shutter 1101010111111 0..2,4,6,8..12    ; 7519
.shutter 1101011000001 0..2,4,6..7       ; 7520
.shutter 1101011000011 0..2,4,6..7,12    ; 7521
.shutter 1101011000101 0..2,4,6..7,11    ; 7522
.shutter 1101011000111 0..2,4,6..7,11..12 ; 7523
.shutter 1101011001001 0..2,4,6..7,10    ; 7524
.shutter 1101011001011 0..2,4,6..7,10,12 ; 7525
.shutter 1101011001101 0..2,4,6..7,10..11 ; 7526
.shutter 1101011001111 0..2,4,6..7,10..12 ; 7527
.shutter 1101011010001 0..2,4,6..7,9     ; 7528
.shutter 1101011010011 0..2,4,6..7,9,12  ; 7529
.shutter 1101011010101 0..2,4,6..7,9,11  ; 7530
.shutter 1101011010111 0..2,4,6..7,9,11..12 ; 7531
.shutter 1101011011001 0..2,4,6..7,9..10 ; 7532
.shutter 1101011011011 0..2,4,6..7,9..10,12 ; 7533
.shutter 1101011011101 0..2,4,6..7,9..11 ; 7534
.shutter 1101011011111 0..2,4,6..7,9..12 ; 7535
.shutter 1101011100001 0..2,4,6..8       ; 7536
.shutter 1101011100011 0..2,4,6..8,12    ; 7537
.shutter 1101011100101 0..2,4,6..8,11    ; 7538
.shutter 1101011100111 0..2,4,6..8,11..12 ; 7539
.shutter 1101011101001 0..2,4,6..8,10    ; 7540
.shutter 1101011101011 0..2,4,6..8,10,12 ; 7541
.shutter 1101011101101 0..2,4,6..8,10..11 ; 7542
.shutter 1101011101111 0..2,4,6..8,10..12 ; 7543
.shutter 1101011110001 0..2,4,6..9       ; 7544
.shutter 1101011110011 0..2,4,6..9,12    ; 7545
.shutter 1101011110101 0..2,4,6..9,11    ; 7546
.shutter 1101011110111 0..2,4,6..9,11..12 ; 7547
.shutter 1101011111001 0..2,4,6..10      ; 7548
.shutter 1101011111011 0..2,4,6..10,12   ; 7549
.shutter 1101011111101 0..2,4,6..11      ; 7550
.shutter 1101011111111 0..2,4,6..12      ; 7551
.shutter 1101100000001 0..2,4..5         ; 7552
.shutter 1101100000011 0..2,4..5,12      ; 7553
.shutter 1101100000101 0..2,4..5,11      ; 7554
.shutter 1101100000111 0..2,4..5,11..12  ; 7555
.shutter 1101100001001 0..2,4..5,10      ; 7556
.shutter 1101100001011 0..2,4..5,10,12   ; 7557
.shutter 1101100001101 0..2,4..5,10..11  ; 7558
.shutter 1101100001111 0..2,4..5,10..12  ; 7559
.shutter 1101100010001 0..2,4..5,9       ; 7560
.shutter 1101100010011 0..2,4..5,9,12    ; 7561
.shutter 1101100010101 0..2,4..5,9,11    ; 7562
.shutter 1101100010111 0..2,4..5,9,11..12 ; 7563
.shutter 1101100011001 0..2,4..5,9..10   ; 7564
.shutter 1101100011011 0..2,4..5,9..10,12 ; 7565
.shutter 1101100011101 0..2,4..5,9..11   ; 7566
.shutter 1101100011111 0..2,4..5,9..12   ; 7567
.shutter 1101100100001 0..2,4..5,8       ; 7568
.shutter 1101100100011 0..2,4..5,8,12    ; 7569
.shutter 1101100100101 0..2,4..5,8,11    ; 7570
.shutter 1101100100111 0..2,4..5,8,11..12 ; 7571
.shutter 1101100101001 0..2,4..5,8,10    ; 7572
.shutter 1101100101011 0..2,4..5,8..12/2 ; 7573
.shutter 1101100101101 0..2,4..5,8,10..11 ; 7574
.shutter 1101100101111 0..2,4..5,8,10..12 ; 7575
.shutter 1101100110001 0..2,4..5,8..9    ; 7576
.shutter 1101100110011 0..2,4..5,8..9,12 ; 7577
.shutter 1101100110101 0..2,4..5,8..9,11 ; 7578
.shutter 1101100110111 0..2,4..5,8..9,11..12 ; 7579
.shutter 1101100111001 0..2,4..5,8..10   ; 7580
.shutter 1101100111011 0..2,4..5,8..10,12 ; 7581
.shutter 1101100111101 0..2,4..5,8..11   ; 7582
.shutter 1101100111111 0..2,4..5,8..12   ; 7583
.shutter 1101101000001 0..2,4..5,7       ; 7584
.shutter 1101101000011 0..2,4..5,7,12    ; 7585
.shutter 1101101000101 0..2,4..5,7,11    ; 7586
.shutter 1101101000111 0..2,4..5,7,11..12 ; 7587
.shutter 1101101001001 0..2,4..5,7,10    ; 7588
.shutter 1101101001011 0..2,4..5,7,10,12 ; 7589
.shutter 1101101001101 0..2,4..5,7,10..11 ; 7590
.shutter 1101101001111 0..2,4..5,7,10..12 ; 7591
.shutter 1101101010001 0..2,4..5,7,9     ; 7592
.shutter 1101101010011 0..2,4..5,7,9,12  ; 7593
.shutter 1101101010101 0..2,4..5,7..11/2 ; 7594
.shutter 1101101010111 0..2,4..5,7..11/2,12 ; 7595
.shutter 1101101011001 0..2,4..5,7,9..10 ; 7596
.shutter 1101101011011 0..2,4..5,7,9..10,12 ; 7597
.shutter 1101101011101 0..2,4..5,7,9..11 ; 7598
.shutter 1101101011111 0..2,4..5,7,9..12 ; 7599
.shutter 1101101100001 0..2,4..5,7..8    ; 7600
.shutter 1101101100011 0..2,4..5,7..8,12 ; 7601
.shutter 1101101100101 0..2,4..5,7..8,11 ; 7602
.shutter 1101101100111 0..2,4..5,7..8,11..12 ; 7603
.shutter 1101101101001 0..2,4..5,7..8,10 ; 7604
.shutter 1101101101011 0..2,4..5,7..8,10,12 ; 7605
.shutter 1101101101101 0..2,4..5,7..8,10..11 ; 7606
.shutter 1101101101111 0..2,4..5,7..8,10..12 ; 7607
.shutter 1101101110001 0..2,4..5,7..9    ; 7608
.shutter 1101101110011 0..2,4..5,7..9,12 ; 7609
.shutter 1101101110101 0..2,4..5,7..9,11 ; 7610
.shutter 1101101110111 0..2,4..5,7..9,11..12 ; 7611
.shutter 1101101111001 0..2,4..5,7..10   ; 7612
.shutter 1101101111011 0..2,4..5,7..10,12 ; 7613
.shutter 1101101111101 0..2,4..5,7..11   ; 7614
.shutter 1101101111111 0..2,4..5,7..12   ; 7615
.shutter 1101110000001 0..2,4..6         ; 7616
.shutter 1101110000011 0..2,4..6,12      ; 7617
.shutter 1101110000101 0..2,4..6,11      ; 7618
.shutter 1101110000111 0..2,4..6,11..12  ; 7619
.shutter 1101110001001 0..2,4..6,10      ; 7620
.shutter 1101110001011 0..2,4..6,10,12   ; 7621
.shutter 1101110001101 0..2,4..6,10..11  ; 7622
.shutter 1101110001111 0..2,4..6,10..12  ; 7623
.shutter 1101110010001 0..2,4..6,9       ; 7624
.shutter 1101110010011 0..2,4..6,9,12    ; 7625
.shutter 1101110010101 0..2,4..6,9,11    ; 7626
.shutter 1101110010111 0..2,4..6,9,11..12 ; 7627
.shutter 1101110011001 0..2,4..6,9..10   ; 7628
.shutter 1101110011011 0..2,4..6,9..10,12 ; 7629
.shutter 1101110011101 0..2,4..6,9..11   ; 7630
.shutter 1101110011111 0..2,4..6,9..12   ; 7631
.shutter 1101110100001 0..2,4..6,8       ; 7632
.shutter 1101110100011 0..2,4..6,8,12    ; 7633
.shutter 1101110100101 0..2,4..6,8,11    ; 7634
.shutter 1101110100111 0..2,4..6,8,11..12 ; 7635
.shutter 1101110101001 0..2,4..6,8,10    ; 7636
.shutter 1101110101011 0..2,4..6,8..12/2 ; 7637
.shutter 1101110101101 0..2,4..6,8,10..11 ; 7638
.shutter 1101110101111 0..2,4..6,8,10..12 ; 7639
.shutter 1101110110001 0..2,4..6,8..9    ; 7640
.shutter 1101110110011 0..2,4..6,8..9,12 ; 7641
.shutter 1101110110101 0..2,4..6,8..9,11 ; 7642
.shutter 1101110110111 0..2,4..6,8..9,11..12 ; 7643
.shutter 1101110111001 0..2,4..6,8..10   ; 7644
.shutter 1101110111011 0..2,4..6,8..10,12 ; 7645
.shutter 1101110111101 0..2,4..6,8..11   ; 7646
.shutter 1101110111111 0..2,4..6,8..12   ; 7647
.shutter 1101111000001 0..2,4..7         ; 7648
.shutter 1101111000011 0..2,4..7,12      ; 7649
.shutter 1101111000101 0..2,4..7,11      ; 7650
.shutter 1101111000111 0..2,4..7,11..12  ; 7651
.shutter 1101111001001 0..2,4..7,10      ; 7652
.shutter 1101111001011 0..2,4..7,10,12   ; 7653
.shutter 1101111001101 0..2,4..7,10..11  ; 7654
.shutter 1101111001111 0..2,4..7,10..12  ; 7655
.shutter 1101111010001 0..2,4..7,9       ; 7656
.shutter 1101111010011 0..2,4..7,9,12    ; 7657
.shutter 1101111010101 0..2,4..7,9,11    ; 7658
.shutter 1101111010111 0..2,4..7,9,11..12 ; 7659
.shutter 1101111011001 0..2,4..7,9..10   ; 7660
.shutter 1101111011011 0..2,4..7,9..10,12 ; 7661
.shutter 1101111011101 0..2,4..7,9..11   ; 7662
.shutter 1101111011111 0..2,4..7,9..12   ; 7663
.shutter 1101111100001 0..2,4..8         ; 7664
.shutter 1101111100011 0..2,4..8,12      ; 7665
.shutter 1101111100101 0..2,4..8,11      ; 7666
.shutter 1101111100111 0..2,4..8,11..12  ; 7667
.shutter 1101111101001 0..2,4..8,10      ; 7668
.shutter 1101111101011 0..2,4..8,10,12   ; 7669
.shutter 1101111101101 0..2,4..8,10..11  ; 7670
.shutter 1101111101111 0..2,4..8,10..12  ; 7671
.shutter 1101111110001 0..2,4..9         ; 7672
.shutter 1101111110011 0..2,4..9,12      ; 7673
.shutter 1101111110101 0..2,4..9,11      ; 7674
.shutter 1101111110111 0..2,4..9,11..12  ; 7675
.shutter 1101111111001 0..2,4..10        ; 7676
.shutter 1101111111011 0..2,4..10,12     ; 7677
.shutter 1101111111101 0..2,4..11        ; 7678
.shutter 1101111111111 0..2,4..12        ; 7679
.shutter 1110000000001 0..3              ; 7680
.shutter 1110000000011 0..3,12           ; 7681
.shutter 1110000000101 0..3,11           ; 7682
.shutter 1110000000111 0..3,11..12       ; 7683
.shutter 1110000001001 0..3,10           ; 7684
.shutter 1110000001011 0..3,10,12        ; 7685
.shutter 1110000001101 0..3,10..11       ; 7686
.shutter 1110000001111 0..3,10..12       ; 7687
.shutter 1110000010001 0..3,9            ; 7688
.shutter 1110000010011 0..3,9,12         ; 7689
.shutter 1110000010101 0..3,9,11         ; 7690
.shutter 1110000010111 0..3,9,11..12     ; 7691
.shutter 1110000011001 0..3,9..10        ; 7692
.shutter 1110000011011 0..3,9..10,12     ; 7693
.shutter 1110000011101 0..3,9..11        ; 7694
.shutter 1110000011111 0..3,9..12        ; 7695
.shutter 1110000100001 0..3,8            ; 7696
.shutter 1110000100011 0..3,8,12         ; 7697
.shutter 1110000100101 0..3,8,11         ; 7698
.shutter 1110000100111 0..3,8,11..12     ; 7699
.shutter 1110000101001 0..3,8,10         ; 7700
.shutter 1110000101011 0..3,8,10,12      ; 7701
.shutter 1110000101101 0..3,8,10..11     ; 7702
.shutter 1110000101111 0..3,8,10..12     ; 7703
.shutter 1110000110001 0..3,8..9         ; 7704
.shutter 1110000110011 0..3,8..9,12      ; 7705
.shutter 1110000110101 0..3,8..9,11      ; 7706
.shutter 1110000110111 0..3,8..9,11..12  ; 7707
.shutter 1110000111001 0..3,8..10        ; 7708
.shutter 1110000111011 0..3,8..10,12     ; 7709
.shutter 1110000111101 0..3,8..11        ; 7710
.shutter 1110000111111 0..3,8..12        ; 7711
.shutter 1110001000001 0..3,7            ; 7712
.shutter 1110001000011 0..3,7,12         ; 7713
.shutter 1110001000101 0..3,7,11         ; 7714
.shutter 1110001000111 0..3,7,11..12     ; 7715
.shutter 1110001001001 0..3,7,10         ; 7716
.shutter 1110001001011 0..3,7,10,12      ; 7717
.shutter 1110001001101 0..3,7,10..11     ; 7718
.shutter 1110001001111 0..3,7,10..12     ; 7719
.shutter 1110001010001 0..3,7,9          ; 7720
.shutter 1110001010011 0..3,7,9,12       ; 7721
.shutter 1110001010101 0..3,7,9,11       ; 7722
.shutter 1110001010111 0..3,7,9,11..12   ; 7723
.shutter 1110001011001 0..3,7,9..10      ; 7724
.shutter 1110001011011 0..3,7,9..10,12   ; 7725
.shutter 1110001011101 0..3,7,9..11      ; 7726
.shutter 1110001011111 0..3,7,9..12      ; 7727
.shutter 1110001100001 0..3,7..8         ; 7728
.shutter 1110001100011 0..3,7..8,12      ; 7729
.shutter 1110001100101 0..3,7..8,11      ; 7730
.shutter 1110001100111 0..3,7..8,11..12  ; 7731
.shutter 1110001101001 0..3,7..8,10      ; 7732
.shutter 1110001101011 0..3,7..8,10,12   ; 7733
.shutter 1110001101101 0..3,7..8,10..11  ; 7734
.shutter 1110001101111 0..3,7..8,10..12  ; 7735
.shutter 1110001110001 0..3,7..9         ; 7736
.shutter 1110001110011 0..3,7..9,12      ; 7737
.shutter 1110001110101 0..3,7..9,11      ; 7738
.shutter 1110001110111 0..3,7..9,11..12  ; 7739
.shutter 1110001111001 0..3,7..10        ; 7740
.shutter 1110001111011 0..3,7..10,12     ; 7741
.shutter 1110001111101 0..3,7..11        ; 7742
.shutter 1110001111111 0..3,7..12        ; 7743
.shutter 1110010000001 0..3,6            ; 7744
.shutter 1110010000011 0..3,6,12         ; 7745
.shutter 1110010000101 0..3,6,11         ; 7746
.shutter 1110010000111 0..3,6,11..12     ; 7747
.shutter 1110010001001 0..3,6,10         ; 7748
.shutter 1110010001011 0..3,6,10,12      ; 7749
.shutter 1110010001101 0..3,6,10..11     ; 7750
.shutter 1110010001111 0..3,6,10..12     ; 7751
.shutter 1110010010001 0..3,6,9          ; 7752
.shutter 1110010010011 0..3,6,9,12       ; 7753
.shutter 1110010010101 0..3,6,9,11       ; 7754
.shutter 1110010010111 0..3,6,9,11..12   ; 7755
.shutter 1110010011001 0..3,6,9..10      ; 7756
.shutter 1110010011011 0..3,6,9..10,12   ; 7757
.shutter 1110010011101 0..3,6,9..11      ; 7758
.shutter 1110010011111 0..3,6,9..12      ; 7759
.shutter 1110010100001 0..3,6,8          ; 7760
.shutter 1110010100011 0..3,6,8,12       ; 7761
.shutter 1110010100101 0..3,6,8,11       ; 7762
.shutter 1110010100111 0..3,6,8,11..12   ; 7763
.shutter 1110010101001 0..3,6,8,10       ; 7764
.shutter 1110010101011 0..3,6..12/2      ; 7765
.shutter 1110010101101 0..3,6,8,10..11   ; 7766
.shutter 1110010101111 0..3,6,8,10..12   ; 7767
.shutter 1110010110001 0..3,6,8..9       ; 7768
.shutter 1110010110011 0..3,6,8..9,12    ; 7769
.shutter 1110010110101 0..3,6,8..9,11    ; 7770
.shutter 1110010110111 0..3,6,8..9,11..12 ; 7771
.shutter 1110010111001 0..3,6,8..10      ; 7772
.shutter 1110010111011 0..3,6,8..10,12   ; 7773
.shutter 1110010111101 0..3,6,8..11      ; 7774
.shutter 1110010111111 0..3,6,8..12      ; 7775
.shutter 1110011000001 0..3,6..7         ; 7776
.shutter 1110011000011 0..3,6..7,12      ; 7777
.shutter 1110011000101 0..3,6..7,11      ; 7778
.shutter 1110011000111 0..3,6..7,11..12  ; 7779
.shutter 1110011001001 0..3,6..7,10      ; 7780
.shutter 1110011001011 0..3,6..7,10,12   ; 7781
.shutter 1110011001101 0..3,6..7,10..11  ; 7782
.shutter 1110011001111 0..3,6..7,10..12  ; 7783
.shutter 1110011010001 0..3,6..7,9       ; 7784
.shutter 1110011010011 0..3,6..7,9,12    ; 7785
.shutter 1110011010101 0..3,6..7,9,11    ; 7786
.shutter 1110011010111 0..3,6..7,9,11..12 ; 7787
.shutter 1110011011001 0..3,6..7,9..10   ; 7788
.shutter 1110011011011 0..3,6..7,9..10,12 ; 7789
.shutter 1110011011101 0..3,6..7,9..11   ; 7790
.shutter 1110011011111 0..3,6..7,9..12   ; 7791
.shutter 1110011100001 0..3,6..8         ; 7792
.shutter 1110011100011 0..3,6..8,12      ; 7793
.shutter 1110011100101 0..3,6..8,11      ; 7794
.shutter 1110011100111 0..3,6..8,11..12  ; 7795
.shutter 1110011101001 0..3,6..8,10      ; 7796
.shutter 1110011101011 0..3,6..8,10,12   ; 7797
.shutter 1110011101101 0..3,6..8,10..11  ; 7798
.shutter 1110011101111 0..3,6..8,10..12  ; 7799
.shutter 1110011110001 0..3,6..9         ; 7800
.shutter 1110011110011 0..3,6..9,12      ; 7801
.shutter 1110011110101 0..3,6..9,11      ; 7802
.shutter 1110011110111 0..3,6..9,11..12  ; 7803
.shutter 1110011111001 0..3,6..10        ; 7804
.shutter 1110011111011 0..3,6..10,12     ; 7805
.shutter 1110011111101 0..3,6..11        ; 7806
.shutter 1110011111111 0..3,6..12        ; 7807
.shutter 1110100000001 0..3,5            ; 7808
.shutter 1110100000011 0..3,5,12         ; 7809
.shutter 1110100000101 0..3,5,11         ; 7810
.shutter 1110100000111 0..3,5,11..12     ; 7811
.shutter 1110100001001 0..3,5,10         ; 7812
.shutter 1110100001011 0..3,5,10,12      ; 7813
.shutter 1110100001101 0..3,5,10..11     ; 7814
.shutter 1110100001111 0..3,5,10..12     ; 7815
.shutter 1110100010001 0..3,5,9          ; 7816
.shutter 1110100010011 0..3,5,9,12       ; 7817
.shutter 1110100010101 0..3,5,9,11       ; 7818
.shutter 1110100010111 0..3,5,9,11..12   ; 7819
.shutter 1110100011001 0..3,5,9..10      ; 7820
.shutter 1110100011011 0..3,5,9..10,12   ; 7821
.shutter 1110100011101 0..3,5,9..11      ; 7822
.shutter 1110100011111 0..3,5,9..12      ; 7823
.shutter 1110100100001 0..3,5,8          ; 7824
.shutter 1110100100011 0..3,5,8,12       ; 7825
.shutter 1110100100101 0..3,5,8,11       ; 7826
.shutter 1110100100111 0..3,5,8,11..12   ; 7827
.shutter 1110100101001 0..3,5,8,10       ; 7828
.shutter 1110100101011 0..3,5,8..12/2    ; 7829
.shutter 1110100101101 0..3,5,8,10..11   ; 7830
.shutter 1110100101111 0..3,5,8,10..12   ; 7831
.shutter 1110100110001 0..3,5,8..9       ; 7832
.shutter 1110100110011 0..3,5,8..9,12    ; 7833
.shutter 1110100110101 0..3,5,8..9,11    ; 7834
.shutter 1110100110111 0..3,5,8..9,11..12 ; 7835
.shutter 1110100111001 0..3,5,8..10      ; 7836
.shutter 1110100111011 0..3,5,8..10,12   ; 7837
.shutter 1110100111101 0..3,5,8..11      ; 7838
.shutter 1110100111111 0..3,5,8..12      ; 7839
.shutter 1110101000001 0..3,5,7          ; 7840
.shutter 1110101000011 0..3,5,7,12       ; 7841
.shutter 1110101000101 0..3,5,7,11       ; 7842
.shutter 1110101000111 0..3,5,7,11..12   ; 7843
.shutter 1110101001001 0..3,5,7,10       ; 7844
.shutter 1110101001011 0..3,5,7,10,12    ; 7845
.shutter 1110101001101 0..3,5,7,10..11   ; 7846
.shutter 1110101001111 0..3,5,7,10..12   ; 7847
.shutter 1110101010001 0..3,5,7,9        ; 7848
.shutter 1110101010011 0..3,5..9/2,12    ; 7849
.shutter 1110101010101 0..3,5..11/2      ; 7850
.shutter 1110101010111 0..3,5..11/2,12   ; 7851
.shutter 1110101011001 0..3,5,7,9..10    ; 7852
.shutter 1110101011011 0..3,5..9/2,10,12 ; 7853
.shutter 1110101011101 0..3,5,7,9..11    ; 7854
.shutter 1110101011111 0..3,5,7,9..12    ; 7855
.shutter 1110101100001 0..3,5,7..8       ; 7856
.shutter 1110101100011 0..3,5,7..8,12    ; 7857
.shutter 1110101100101 0..3,5,7..8,11    ; 7858
.shutter 1110101100111 0..3,5,7..8,11..12 ; 7859
.shutter 1110101101001 0..3,5,7..8,10    ; 7860
.shutter 1110101101011 0..3,5,7..8,10,12 ; 7861
.shutter 1110101101101 0..3,5,7..8,10..11 ; 7862
.shutter 1110101101111 0..3,5,7..8,10..12 ; 7863
.shutter 1110101110001 0..3,5,7..9       ; 7864
.shutter 1110101110011 0..3,5,7..9,12    ; 7865
.shutter 1110101110101 0..3,5,7..9,11    ; 7866
.shutter 1110101110111 0..3,5,7..9,11..12 ; 7867
.shutter 1110101111001 0..3,5,7..10      ; 7868
.shutter 1110101111011 0..3,5,7..10,12   ; 7869
.shutter 1110101111101 0..3,5,7..11      ; 7870
.shutter 1110101111111 0..3,5,7..12      ; 7871
.shutter 1110110000001 0..3,5..6         ; 7872
.shutter 1110110000011 0..3,5..6,12      ; 7873
.shutter 1110110000101 0..3,5..6,11      ; 7874
.shutter 1110110000111 0..3,5..6,11..12  ; 7875
.shutter 1110110001001 0..3,5..6,10      ; 7876
.shutter 1110110001011 0..3,5..6,10,12   ; 7877
.shutter 1110110001101 0..3,5..6,10..11  ; 7878
.shutter 1110110001111 0..3,5..6,10..12  ; 7879
.shutter 1110110010001 0..3,5..6,9       ; 7880
.shutter 1110110010011 0..3,5..6,9,12    ; 7881
.shutter 1110110010101 0..3,5..6,9,11    ; 7882
.shutter 1110110010111 0..3,5..6,9,11..12 ; 7883
.shutter 1110110011001 0..3,5..6,9..10   ; 7884
.shutter 1110110011011 0..3,5..6,9..10,12 ; 7885
.shutter 1110110011101 0..3,5..6,9..11   ; 7886
.shutter 1110110011111 0..3,5..6,9..12   ; 7887
.shutter 1110110100001 0..3,5..6,8       ; 7888
.shutter 1110110100011 0..3,5..6,8,12    ; 7889
.shutter 1110110100101 0..3,5..6,8,11    ; 7890
.shutter 1110110100111 0..3,5..6,8,11..12 ; 7891
.shutter 1110110101001 0..3,5..6,8,10    ; 7892
.shutter 1110110101011 0..3,5..6,8..12/2 ; 7893
.shutter 1110110101101 0..3,5..6,8,10..11 ; 7894
.shutter 1110110101111 0..3,5..6,8,10..12 ; 7895
.shutter 1110110110001 0..3,5..6,8..9    ; 7896
.shutter 1110110110011 0..3,5..6,8..9,12 ; 7897
.shutter 1110110110101 0..3,5..6,8..9,11 ; 7898
.shutter 1110110110111 0..3,5..6,8..9,11..12 ; 7899
.shutter 1110110111001 0..3,5..6,8..10   ; 7900
.shutter 1110110111011 0..3,5..6,8..10,12 ; 7901
.shutter 1110110111101 0..3,5..6,8..11   ; 7902
.shutter 1110110111111 0..3,5..6,8..12   ; 7903
.shutter 1110111000001 0..3,5..7         ; 7904
.shutter 1110111000011 0..3,5..7,12      ; 7905
.shutter 1110111000101 0..3,5..7,11      ; 7906
.shutter 1110111000111 0..3,5..7,11..12  ; 7907
.shutter 1110111001001 0..3,5..7,10      ; 7908
.shutter 1110111001011 0..3,5..7,10,12   ; 7909
.shutter 1110111001101 0..3,5..7,10..11  ; 7910
.shutter 1110111001111 0..3,5..7,10..12  ; 7911
.shutter 1110111010001 0..3,5..7,9       ; 7912
.shutter 1110111010011 0..3,5..7,9,12    ; 7913
.shutter 1110111010101 0..3,5..7,9,11    ; 7914
.shutter 1110111010111 0..3,5..7,9,11..12 ; 7915
.shutter 1110111011001 0..3,5..7,9..10   ; 7916
.shutter 1110111011011 0..3,5..7,9..10,12 ; 7917
.shutter 1110111011101 0..3,5..7,9..11   ; 7918
.shutter 1110111011111 0..3,5..7,9..12   ; 7919
.shutter 1110111100001 0..3,5..8         ; 7920
.shutter 1110111100011 0..3,5..8,12      ; 7921
.shutter 1110111100101 0..3,5..8,11      ; 7922
.shutter 1110111100111 0..3,5..8,11..12  ; 7923
.shutter 1110111101001 0..3,5..8,10      ; 7924
.shutter 1110111101011 0..3,5..8,10,12   ; 7925
.shutter 1110111101101 0..3,5..8,10..11  ; 7926
.shutter 1110111101111 0..3,5..8,10..12  ; 7927
.shutter 1110111110001 0..3,5..9         ; 7928
.shutter 1110111110011 0..3,5..9,12      ; 7929
.shutter 1110111110101 0..3,5..9,11      ; 7930
.shutter 1110111110111 0..3,5..9,11..12  ; 7931
.shutter 1110111111001 0..3,5..10        ; 7932
.shutter 1110111111011 0..3,5..10,12     ; 7933
.shutter 1110111111101 0..3,5..11        ; 7934
.shutter 1110111111111 0..3,5..12        ; 7935
.shutter 1111000000001 0..4              ; 7936
.shutter 1111000000011 0..4,12           ; 7937
.shutter 1111000000101 0..4,11           ; 7938
.shutter 1111000000111 0..4,11..12       ; 7939
.shutter 1111000001001 0..4,10           ; 7940
.shutter 1111000001011 0..4,10,12        ; 7941
.shutter 1111000001101 0..4,10..11       ; 7942
.shutter 1111000001111 0..4,10..12       ; 7943
.shutter 1111000010001 0..4,9            ; 7944
.shutter 1111000010011 0..4,9,12         ; 7945
.shutter 1111000010101 0..4,9,11         ; 7946
.shutter 1111000010111 0..4,9,11..12     ; 7947
.shutter 1111000011001 0..4,9..10        ; 7948
.shutter 1111000011011 0..4,9..10,12     ; 7949
.shutter 1111000011101 0..4,9..11        ; 7950
.shutter 1111000011111 0..4,9..12        ; 7951
.shutter 1111000100001 0..4,8            ; 7952
.shutter 1111000100011 0..4,8,12         ; 7953
.shutter 1111000100101 0..4,8,11         ; 7954
.shutter 1111000100111 0..4,8,11..12     ; 7955
.shutter 1111000101001 0..4,8,10         ; 7956
.shutter 1111000101011 0..4,8,10,12      ; 7957
.shutter 1111000101101 0..4,8,10..11     ; 7958
.shutter 1111000101111 0..4,8,10..12     ; 7959
.shutter 1111000110001 0..4,8..9         ; 7960
.shutter 1111000110011 0..4,8..9,12      ; 7961
.shutter 1111000110101 0..4,8..9,11      ; 7962
.shutter 1111000110111 0..4,8..9,11..12  ; 7963
.shutter 1111000111001 0..4,8..10        ; 7964
.shutter 1111000111011 0..4,8..10,12     ; 7965
.shutter 1111000111101 0..4,8..11        ; 7966
.shutter 1111000111111 0..4,8..12        ; 7967
.shutter 1111001000001 0..4,7            ; 7968
.shutter 1111001000011 0..4,7,12         ; 7969
.shutter 1111001000101 0..4,7,11         ; 7970
.shutter 1111001000111 0..4,7,11..12     ; 7971
.shutter 1111001001001 0..4,7,10         ; 7972
.shutter 1111001001011 0..4,7,10,12      ; 7973
.shutter 1111001001101 0..4,7,10..11     ; 7974
.shutter 1111001001111 0..4,7,10..12     ; 7975
.shutter 1111001010001 0..4,7,9          ; 7976
.shutter 1111001010011 0..4,7,9,12       ; 7977
.shutter 1111001010101 0..4,7,9,11       ; 7978
.shutter 1111001010111 0..4,7,9,11..12   ; 7979
.shutter 1111001011001 0..4,7,9..10      ; 7980
.shutter 1111001011011 0..4,7,9..10,12   ; 7981
.shutter 1111001011101 0..4,7,9..11      ; 7982
.shutter 1111001011111 0..4,7,9..12      ; 7983
.shutter 1111001100001 0..4,7..8         ; 7984
.shutter 1111001100011 0..4,7..8,12      ; 7985
.shutter 1111001100101 0..4,7..8,11      ; 7986
.shutter 1111001100111 0..4,7..8,11..12  ; 7987
.shutter 1111001101001 0..4,7..8,10      ; 7988
.shutter 1111001101011 0..4,7..8,10,12   ; 7989
.shutter 1111001101101 0..4,7..8,10..11  ; 7990
.shutter 1111001101111 0..4,7..8,10..12  ; 7991
.shutter 1111001110001 0..4,7..9         ; 7992
.shutter 1111001110011 0..4,7..9,12      ; 7993
.shutter 1111001110101 0..4,7..9,11      ; 7994
.shutter 1111001110111 0..4,7..9,11..12  ; 7995
.shutter 1111001111001 0..4,7..10        ; 7996
.shutter 1111001111011 0..4,7..10,12     ; 7997
.shutter 1111001111101 0..4,7..11        ; 7998
.shutter 1111001111111 0..4,7..12        ; 7999
.shutter 1111010000001 0..4,6            ; 8000
.shutter 1111010000011 0..4,6,12         ; 8001
.shutter 1111010000101 0..4,6,11         ; 8002
.shutter 1111010000111 0..4,6,11..12     ; 8003
.shutter 1111010001001 0..4,6,10         ; 8004
.shutter 1111010001011 0..4,6,10,12      ; 8005
.shutter 1111010001101 0..4,6,10..11     ; 8006
.shutter 1111010001111 0..4,6,10..12     ; 8007
.shutter 1111010010001 0..4,6,9          ; 8008
.shutter 1111010010011 0..4,6,9,12       ; 8009
.shutter 1111010010101 0..4,6,9,11       ; 8010
.shutter 1111010010111 0..4,6,9,11..12   ; 8011
.shutter 1111010011001 0..4,6,9..10      ; 8012
.shutter 1111010011011 0..4,6,9..10,12   ; 8013
.shutter 1111010011101 0..4,6,9..11      ; 8014
.shutter 1111010011111 0..4,6,9..12      ; 8015
.shutter 1111010100001 0..4,6,8          ; 8016
.shutter 1111010100011 0..4,6,8,12       ; 8017
.shutter 1111010100101 0..4,6,8,11       ; 8018
.shutter 1111010100111 0..4,6,8,11..12   ; 8019
.shutter 1111010101001 0..4,6,8,10       ; 8020
.shutter 1111010101011 0..4,6..12/2      ; 8021
.shutter 1111010101101 0..4,6,8,10..11   ; 8022
.shutter 1111010101111 0..4,6,8,10..12   ; 8023
.shutter 1111010110001 0..4,6,8..9       ; 8024
.shutter 1111010110011 0..4,6,8..9,12    ; 8025
.shutter 1111010110101 0..4,6,8..9,11    ; 8026
.shutter 1111010110111 0..4,6,8..9,11..12 ; 8027
.shutter 1111010111001 0..4,6,8..10      ; 8028
.shutter 1111010111011 0..4,6,8..10,12   ; 8029
.shutter 1111010111101 0..4,6,8..11      ; 8030
.shutter 1111010111111 0..4,6,8..12      ; 8031
.shutter 1111011000001 0..4,6..7         ; 8032
.shutter 1111011000011 0..4,6..7,12      ; 8033
.shutter 1111011000101 0..4,6..7,11      ; 8034
.shutter 1111011000111 0..4,6..7,11..12  ; 8035
.shutter 1111011001001 0..4,6..7,10      ; 8036
.shutter 1111011001011 0..4,6..7,10,12   ; 8037
.shutter 1111011001101 0..4,6..7,10..11  ; 8038
.shutter 1111011001111 0..4,6..7,10..12  ; 8039
.shutter 1111011010001 0..4,6..7,9       ; 8040
.shutter 1111011010011 0..4,6..7,9,12    ; 8041
.shutter 1111011010101 0..4,6..7,9,11    ; 8042
.shutter 1111011010111 0..4,6..7,9,11..12 ; 8043
.shutter 1111011011001 0..4,6..7,9..10   ; 8044
.shutter 1111011011011 0..4,6..7,9..10,12 ; 8045
.shutter 1111011011101 0..4,6..7,9..11   ; 8046
.shutter 1111011011111 0..4,6..7,9..12   ; 8047
.shutter 1111011100001 0..4,6..8         ; 8048
.shutter 1111011100011 0..4,6..8,12      ; 8049
.shutter 1111011100101 0..4,6..8,11      ; 8050
.shutter 1111011100111 0..4,6..8,11..12  ; 8051
.shutter 1111011101001 0..4,6..8,10      ; 8052
.shutter 1111011101011 0..4,6..8,10,12   ; 8053
.shutter 1111011101101 0..4,6..8,10..11  ; 8054
.shutter 1111011101111 0..4,6..8,10..12  ; 8055
.shutter 1111011110001 0..4,6..9         ; 8056
.shutter 1111011110011 0..4,6..9,12      ; 8057
.shutter 1111011110101 0..4,6..9,11      ; 8058
.shutter 1111011110111 0..4,6..9,11..12  ; 8059
.shutter 1111011111001 0..4,6..10        ; 8060
.shutter 1111011111011 0..4,6..10,12     ; 8061
.shutter 1111011111101 0..4,6..11        ; 8062
.shutter 1111011111111 0..4,6..12        ; 8063
.shutter 1111100000001 0..5              ; 8064
.shutter 1111100000011 0..5,12           ; 8065
.shutter 1111100000101 0..5,11           ; 8066
.shutter 1111100000111 0..5,11..12       ; 8067
.shutter 1111100001001 0..5,10           ; 8068
.shutter 1111100001011 0..5,10,12        ; 8069
.shutter 1111100001101 0..5,10..11       ; 8070
.shutter 1111100001111 0..5,10..12       ; 8071
.shutter 1111100010001 0..5,9            ; 8072
.shutter 1111100010011 0..5,9,12         ; 8073
.shutter 1111100010101 0..5,9,11         ; 8074
.shutter 1111100010111 0..5,9,11..12     ; 8075
.shutter 1111100011001 0..5,9..10        ; 8076
.shutter 1111100011011 0..5,9..10,12     ; 8077
.shutter 1111100011101 0..5,9..11        ; 8078
.shutter 1111100011111 0..5,9..12        ; 8079
.shutter 1111100100001 0..5,8            ; 8080
.shutter 1111100100011 0..5,8,12         ; 8081
.shutter 1111100100101 0..5,8,11         ; 8082
.shutter 1111100100111 0..5,8,11..12     ; 8083
.shutter 1111100101001 0..5,8,10         ; 8084
.shutter 1111100101011 0..5,8,10,12      ; 8085
.shutter 1111100101101 0..5,8,10..11     ; 8086
.shutter 1111100101111 0..5,8,10..12     ; 8087
.shutter 1111100110001 0..5,8..9         ; 8088
.shutter 1111100110011 0..5,8..9,12      ; 8089
.shutter 1111100110101 0..5,8..9,11      ; 8090
.shutter 1111100110111 0..5,8..9,11..12  ; 8091
.shutter 1111100111001 0..5,8..10        ; 8092
.shutter 1111100111011 0..5,8..10,12     ; 8093
.shutter 1111100111101 0..5,8..11        ; 8094
.shutter 1111100111111 0..5,8..12        ; 8095
.shutter 1111101000001 0..5,7            ; 8096
.shutter 1111101000011 0..5,7,12         ; 8097
.shutter 1111101000101 0..5,7,11         ; 8098
.shutter 1111101000111 0..5,7,11..12     ; 8099
.shutter 1111101001001 0..5,7,10         ; 8100
.shutter 1111101001011 0..5,7,10,12      ; 8101
.shutter 1111101001101 0..5,7,10..11     ; 8102
.shutter 1111101001111 0..5,7,10..12     ; 8103
.shutter 1111101010001 0..5,7,9          ; 8104
.shutter 1111101010011 0..5,7,9,12       ; 8105
.shutter 1111101010101 0..5,7,9,11       ; 8106
.shutter 1111101010111 0..5,7,9,11..12   ; 8107
.shutter 1111101011001 0..5,7,9..10      ; 8108
.shutter 1111101011011 0..5,7,9..10,12   ; 8109
.shutter 1111101011101 0..5,7,9..11      ; 8110
.shutter 1111101011111 0..5,7,9..12      ; 8111
.shutter 1111101100001 0..5,7..8         ; 8112
.shutter 1111101100011 0..5,7..8,12      ; 8113
.shutter 1111101100101 0..5,7..8,11      ; 8114
.shutter 1111101100111 0..5,7..8,11..12  ; 8115
.shutter 1111101101001 0..5,7..8,10      ; 8116
.shutter 1111101101011 0..5,7..8,10,12   ; 8117
.shutter 1111101101101 0..5,7..8,10..11  ; 8118
.shutter 1111101101111 0..5,7..8,10..12  ; 8119
.shutter 1111101110001 0..5,7..9         ; 8120
.shutter 1111101110011 0..5,7..9,12      ; 8121
.shutter 1111101110101 0..5,7..9,11      ; 8122
.shutter 1111101110111 0..5,7..9,11..12  ; 8123
.shutter 1111101111001 0..5,7..10        ; 8124
.shutter 1111101111011 0..5,7..10,12     ; 8125
.shutter 1111101111101 0..5,7..11        ; 8126
.shutter 1111101111111 0..5,7..12        ; 8127
.shutter 1111110000001 0..6              ; 8128
.shutter 1111110000011 0..6,12           ; 8129
.shutter 1111110000101 0..6,11           ; 8130
.shutter 1111110000111 0..6,11..12       ; 8131
.shutter 1111110001001 0..6,10           ; 8132
.shutter 1111110001011 0..6,10,12        ; 8133
.shutter 1111110001101 0..6,10..11       ; 8134
.shutter 1111110001111 0..6,10..12       ; 8135
.shutter 1111110010001 0..6,9            ; 8136
.shutter 1111110010011 0..6,9,12         ; 8137
.shutter 1111110010101 0..6,9,11         ; 8138
.shutter 1111110010111 0..6,9,11..12     ; 8139
.shutter 1111110011001 0..6,9..10        ; 8140
.shutter 1111110011011 0..6,9..10,12     ; 8141
.shutter 1111110011101 0..6,9..11        ; 8142
.shutter 1111110011111 0..6,9..12        ; 8143
.shutter 1111110100001 0..6,8            ; 8144
.shutter 1111110100011 0..6,8,12         ; 8145
.shutter 1111110100101 0..6,8,11         ; 8146
.shutter 1111110100111 0..6,8,11..12     ; 8147
.shutter 1111110101001 0..6,8,10         ; 8148
.shutter 1111110101011 0..6,8,10,12      ; 8149
.shutter 1111110101101 0..6,8,10..11     ; 8150
.shutter 1111110101111 0..6,8,10..12     ; 8151
.shutter 1111110110001 0..6,8..9         ; 8152
.shutter 1111110110011 0..6,8..9,12      ; 8153
.shutter 1111110110101 0..6,8..9,11      ; 8154
.shutter 1111110110111 0..6,8..9,11..12  ; 8155
.shutter 1111110111001 0..6,8..10        ; 8156
.shutter 1111110111011 0..6,8..10,12     ; 8157
.shutter 1111110111101 0..6,8..11        ; 8158
.shutter 1111110111111 0..6,8..12        ; 8159
.shutter 1111111000001 0..7              ; 8160
.shutter 1111111000011 0..7,12           ; 8161
.shutter 1111111000101 0..7,11           ; 8162
.shutter 1111111000111 0..7,11..12       ; 8163
.shutter 1111111001001 0..7,10           ; 8164
.shutter 1111111001011 0..7,10,12        ; 8165
.shutter 1111111001101 0..7,10..11       ; 8166
.shutter 1111111001111 0..7,10..12       ; 8167
.shutter 1111111010001 0..7,9            ; 8168
.shutter 1111111010011 0..7,9,12         ; 8169
.shutter 1111111010101 0..7,9,11         ; 8170
.shutter 1111111010111 0..7,9,11..12     ; 8171
.shutter 1111111011001 0..7,9..10        ; 8172
.shutter 1111111011011 0..7,9..10,12     ; 8173
.shutter 1111111011101 0..7,9..11        ; 8174
.shutter 1111111011111 0..7,9..12        ; 8175
.shutter 1111111100001 0..8              ; 8176
.shutter 1111111100011 0..8,12           ; 8177
.shutter 1111111100101 0..8,11           ; 8178
.shutter 1111111100111 0..8,11..12       ; 8179
.shutter 1111111101001 0..8,10           ; 8180
.shutter 1111111101011 0..8,10,12        ; 8181
.shutter 1111111101101 0..8,10..11       ; 8182
.shutter 1111111101111 0..8,10..12       ; 8183
.shutter 1111111110001 0..9              ; 8184
.shutter 1111111110011 0..9,12           ; 8185
.shutter 1111111110101 0..9,11           ; 8186
.shutter 1111111110111 0..9,11..12       ; 8187
.shutter 1111111111001 0..10             ; 8188
.shutter 1111111111011 0..10,12          ; 8189
.shutter 1111111111101 0..11             ; 8190
.shutter 1111111111111 0..12             ; 8191
; a line a code: its shutter, then its fields
.code 0 0
.code 4096 1
.code 2048 2
.code 6144 3
.code 1024 4
.code 5120 5
.code 3072 6
.code 7168 7
.code 512 8
.code 4608 9
.code 2560 10
.code 6656 11
.code 1536 12
.code 5632 13
.code 3584 14
.code 7680 15
.code 256 16
.code 4352 17
.code 2304 18
.code 6400 19
.code 1280 20
.code 5376 21
.code 3328 22
.code 7424 23
.code 768 24
.code 4864 25
.code 2816 26
.code 6912 27
.code 1792 28
.code 5888 29
.code 3840 30
.code 7936 31
.code 128 32
.code 4224 33
.code 2176 34
.code 6272 35
.code 1152 36
.code 5248 37
.code 3200 38
.code 7296 39
.code 640 40
.code 4736 41
.code 2688 42
.code 6784 43
.code 1664 44
.code 5760 45
.code 3712 46
.code 7808 47
.code 384 48
.code 4480 49
.code 2432 50
.code 6528 51
.code 1408 52
.code 5504 53
.code 3456 54
.code 7552 55
.code 896 56
.code 4992 57
.code 2944 58
.code 7040 59
.code 1920 60
.code 6016 61
.code 3968 62
.code 8064 63
.code 64 64
.code 4160 65
.code 2112 66
.code 6208 67
.code 1088 68
.code 5184 69
.code 3136 70
.code 7232 71
.code 576 72
.code 4672 73
.code 2624 74
.code 6720 75
.code 1600 76
.code 5696 77
.code 3648 78
.code 7744 79
.code 320 80
.code 4416 81
.code 2368 82
.code 6464 83
.code 1344 84
.code 5440 85
.code 3392 86
.code 7488 87
.code 832 88
.code 4928 89
.code 2880 90
.code 6976 91
.code 1856 92
.code 5952 93
.code 3904 94
.code 8000 95
.code 192 96
.code 4288 97
.code 2240 98
.code 6336 99
.code 1216 100
.code 5312 101
.code 3264 102
.code 7360 103
.code 704 104
.code 4800 105
.code 2752 106
.code 6848 107
.code 1728 108
.code 5824 109
.code 3776 110
.code 7872 111
.code 448 112
.code 4544 113
.code 2496 114
.code 6592 115
.code 1472 116
.code 5568 117
.code 3520 118
.code 7616 119
.code 960 120
.code 5056 121
.code 3008 122
.code 7104 123
.code 1984 124
.code 6080 125
.code 4032 126
.code 8128 127
.code 32 128
.code 4128 129
.code 2080 130
.code 6176 131
.code 1056 132
.code 5152 133
.code 3104 134
.code 7200 135
.code 544 136
.code 4640 137
.code 2592 138
.code 6688 139
.code 1568 140
.code 5664 141
.code 3616 142
.code 7712 143
.code 288 144
.code 4384 145
.code 2336 146
.code 6432 147
.code 1312 148
.code 5408 149
.code 3360 150
.code 7456 151
.code 800 152
.code 4896 153
.code 2848 154
.code 6944 155
.code 1824 156
.code 5920 157
.code 3872 158
.code 7968 159
.code 160 160
.code 4256 161
.code 2208 162
.code 6304 163
.code 1184 164
.code 5280 165
.code 3232 166
.code 7328 167
.code 672 168
.code 4768 169
.code 2720 170
.code 6816 171
.code 1696 172
.code 5792 173
.code 3744 174
.code 7840 175
.code 416 176
.code 4512 177
.code 2464 178
.code 6560 179
.code 1440 180
.code 5536 181
.code 3488 182
.code 7584 183
.code 928 184
.code 5024 185
.code 2976 186
.code 7072 187
.code 1952 188
.code 6048 189
.code 4000 190
.code 8096 191
.code 96 192
.code 4192 193
.code 2144 194
.code 6240 195
.code 1120 196
.code 5216 197
.code 3168 198
.code 7264 199
.code 608 200
.code 4704 201
.code 2656 202
.code 6752 203
.code 1632 204
.code 5728 205
.code 3680 206
.code 7776 207
.code 352 208
.code 4448 209
.code 2400 210
.code 6496 211
.code 1376 212
.code 5472 213
.code 3424 214
.code 7520 215
.code 864 216
.code 4960 217
.code 2912 218
.code 7008 219
.code 1888 220
.code 5984 221
.code 3936 222
.code 8032 223
.code 224 224
.code 4320 225
.code 2272 226
.code 6368 227
.code 1248 228
.code 5344 229
.code 3296 230
.code 7392 231
.code 736 232
.code 4832 233
.code 2784 234
.code 6880 235
.code 1760 236
.code 5856 237
.code 3808 238
.code 7904 239
.code 480 240
.code 4576 241
.code 2528 242
.code 6624 243
.code 1504 244
.code 5600 245
.code 3552 246
.code 7648 247
.code 992 248
.code 5088 249
.code 3040 250
.code 7136 251
.code 2016 252
.code 6112 253
.code 4064 254
.code 8160 255
.code 16 256
.code 4112 257
.code 2064 258
.code 6160 259
.code 1040 260
.code 5136 261
.code 3088 262
.code 7184 263
.code 528 264
.code 4624 265
.code 2576 266
.code 6672 267
.code 1552 268
.code 5648 269
.code 3600 270
.code 7696 271
.code 272 272
.code 4368 273
.code 2320 274
.code 6416 275
.code 1296 276
.code 5392 277
.code 3344 278
.code 7440 279
.code 784 280
.code 4880 281
.code 2832 282
.code 6928 283
.code 1808 284
.code 5904 285
.code 3856 286
.code 7952 287
.code 144 288
.code 4240 289
.code 2192 290
.code 6288 291
.code 1168 292
.code 5264 293
.code 3216 294
.code 7312 295
.code 656 296
.code 4752 297
.code 2704 298
.code 6800 299
.code 1680 300
.code 5776 301
.code 3728 302
.code 7824 303
.code 400 304
.code 4496 305
.code 2448 306
.code 6544 307
.code 1424 308
.code 5520 309
.code 3472 310
.code 7568 311
.code 912 312
.code 5008 313
.code 2960 314
.code 7056 315
.code 1936 316
.code 6032 317
.code 3984 318
.code 8080 319
.code 80 320
.code 4176 321
.code 2128 322
.code 6224 323
.code 1104 324
.code 5200 325
.code 3152 326
.code 7248 327
.code 592 328
.code 4688 329
.code 2640 330
.code 6736 331
.code 1616 332
.code 5712 333
.code 3664 334
.code 7760 335
.code 336 336
.code 4432 337
.code 2384 338
.code 6480 339
.code 1360 340
.code 5456 341
.code 3408 342
.code 7504 343
.code 848 344
.code 4944 345
.code 2896 346
.code 6992 347
.code 1872 348
.code 5968 349
.code 3920 350
.code 8016 351
.code 208 352
.code 4304 353
.code 2256 354
.code 6352 355
.code 1232 356
.code 5328 357
.code 3280 358
.code 7376 359
.code 720 360
.code 4816 361
.code 2768 362
.code 6864 363
.code 1744 364
.code 5840 365
.code 3792 366
.code 7888 367
.code 464 368
.code 4560 369
.code 2512 370
.code 6608 371
.code 1488 372
.code 5584 373
.code 3536 374
.code 7632 375
.code 976 376
.code 5072 377
.code 3024 378
.code 7120 379
.code 2000 380
.code 6096 381
.code 4048 382
.code 8144 383
.code 48 384
.code 4144 385
.code 2096 386
.code 6192 387
.code 1072 388
.code 5168 389
.code 3120 390
.code 7216 391
.code 560 392
.code 4656 393
.code 2608 394
.code 6704 395
.code 1584 396
.code 5680 397
.code 3632 398
.code 7728 399
.code 304 400
.code 4400 401
.code 2352 402
.code 6448 403
.code 1328 404
.code 5424 405
.code 3376 406
.code 7472 407
.code 816 408
.code 4912 409
.code 2864 410
.code 6960 411
.code 1840 412
.code 5936 413
.code 3888 414
.code 7984 415
.code 176 416
.code 4272 417
.code 2224 418
.code 6320 419
.code 1200 420
.code 5296 421
.code 3248 422
.code 7344 423
.code 688 424
.code 4784 425
.code 2736 426
.code 6832 427
.code 1712 428
.code 5808 429
.code 3760 430
.code 7856 431
.code 432 432
.code 4528 433
.code 2480 434
.code 6576 435
.code 1456 436
.code 5552 437
.code 3504 438
.code 7600 439
.code 944 440
.code 5040 441
.code 2992 442
.code 7088 443
.code 1968 444
.code 6064 445
.code 4016 446
.code 8112 447
.code 112 448
.code 4208 449
.code 2160 450
.code 6256 451
.code 1136 452
.code 5232 453
.code 3184 454
.code 7280 455
.code 624 456
.code 4720 457
.code 2672 458
.code 6768 459
.code 1648 460
.code 5744 461
.code 3696 462
.code 7792 463
.code 368 464
.code 4464 465
.code 2416 466
.code 6512 467
.code 1392 468
.code 5488 469
.code 3440 470
.code 7536 471
.code 880 472
.code 4976 473
.code 2928 474
.code 7024 475
.code 1904 476
.code 6000 477
.code 3952 478
.code 8048 479
.code 240 480
.code 4336 481
.code 2288 482
.code 6384 483
.code 1264 484
.code 5360 485
.code 3312 486
.code 7408 487
.code 752 488
.code 4848 489
.code 2800 490
.code 6896 491
.code 1776 492
.code 5872 493
.code 3824 494
.code 7920 495
.code 496 496
.code 4592 497
.code 2544 498
.code 6640 499
.code 1520 500
.code 5616 501
.code 3568 502
.code 7664 503
.code 1008 504
.code 5104 505
.code 3056 506
.code 7152 507
.code 2032 508
.code 6128 509
.code 4080 510
.code 8176 511
.code 8 512
.code 4104 513
.code 2056 514
.code 6152 515
.code 1032 516
.code 5128 517
.code 3080 518
.code 7176 519
.code 520 520
.code 4616 521
.code 2568 522
.code 6664 523
.code 1544 524
.code 5640 525
.code 3592 526
.code 7688 527
.code 264 528
.code 4360 529
.code 2312 530
.code 6408 531
.code 1288 532
.code 5384 533
.code 3336 534
.code 7432 535
.code 776 536
.code 4872 537
.code 2824 538
.code 6920 539
.code 1800 540
.code 5896 541
.code 3848 542
.code 7944 543
.code 136 544
.code 4232 545
.code 2184 546
.code 6280 547
.code 1160 548
.code 5256 549
.code 3208 550
.code 7304 551
.code 648 552
.code 4744 553
.code 2696 554
.code 6792 555
.code 1672 556
.code 5768 557
.code 3720 558
.code 7816 559
.code 392 560
.code 4488 561
.code 2440 562
.code 6536 563
.code 1416 564
.code 5512 565
.code 3464 566
.code 7560 567
.code 904 568
.code 5000 569
.code 2952 570
.code 7048 571
.code 1928 572
.code 6024 573
.code 3976 574
.code 8072 575
.code 72 576
.code 4168 577
.code 2120 578
.code 6216 579
.code 1096 580
.code 5192 581
.code 3144 582
.code 7240 583
.code 584 584
.code 4680 585
.code 2632 586
.code 6728 587
.code 1608 588
.code 5704 589
.code 3656 590
.code 7752 591
.code 328 592
.code 4424 593
.code 2376 594
.code 6472 595
.code 1352 596
.code 5448 597
.code 3400 598
.code 7496 599
.code 840 600
.code 4936 601
.code 2888 602
.code 6984 603
.code 1864 604
.code 5960 605
.code 3912 606
.code 8008 607
.code 200 608
.code 4296 609
.code 2248 610
.code 6344 611
.code 1224 612
.code 5320 613
.code 3272 614
.code 7368 615
.code 712 616
.code 4808 617
.code 2760 618
.code 6856 619
.code 1736 620
.code 5832 621
.code 3784 622
.code 7880 623
.code 456 624
.code 4552 625
.code 2504 626
.code 6600 627
.code 1480 628
.code 5576 629
.code 3528 630
.code 7624 631
.code 968 632
.code 5064 633
.code 3016 634
.code 7112 635
.code 1992 636
.code 6088 637
.code 4040 638
.code 8136 639
.code 40 640
.code 4136 641
.code 2088 642
.code 6184 643
.code 1064 644
.code 5160 645
.code 3112 646
.code 7208 647
.code 552 648
.code 4648 649
.code 2600 650
.code 6696 651
.code 1576 652
.code 5672 653
.code 3624 654
.code 7720 655
.code 296 656
.code 4392 657
.code 2344 658
.code 6440 659
.code 1320 660
.code 5416 661
.code 3368 662
.code 7464 663
.code 808 664
.code 4904 665
.code 2856 666
.code 6952 667
.code 1832 668
.code 5928 669
.code 3880 670
.code 7976 671
.code 168 672
.code 4264 673
.code 2216 674
.code 6312 675
.code 1192 676
.code 5288 677
.code 3240 678
.code 7336 679
.code 680 680
.code 4776 681
.code 2728 682
.code 6824 683
.code 1704 684
.code 5800 685
.code 3752 686
.code 7848 687
.code 424 688
.code 4520 689
.code 2472 690
.code 6568 691
.code 1448 692
.code 5544 693
.code 3496 694
.code 7592 695
.code 936 696
.code 5032 697
.code 2984 698
.code 7080 699
.code 1960 700
.code 6056 701
.code 4008 702
.code 8104 703
.code 104 704
.code 4200 705
.code 2152 706
.code 6248 707
.code 1128 708
.code 5224 709
.code 3176 710
.code 7272 711
.code 616 712
.code 4712 713
.code 2664 714
.code 6760 715
.code 1640 716
.code 5736 717
.code 3688 718
.code 7784 719
.code 360 720
.code 4456 721
.code 2408 722
.code 6504 723
.code 1384 724
.code 5480 725
.code 3432 726
.code 7528 727
.code 872 728
.code 4968 729
.code 2920 730
.code 7016 731
.code 1896 732
.code 5992 733
.code 3944 734
.code 8040 735
.code 232 736
.code 4328 737
.code 2280 738
.code 6376 739
.code 1256 740
.code 5352 741
.code 3304 742
.code 7400 743
.code 744 744
.code 4840 745
.code 2792 746
.code 6888 747
.code 1768 748
.code 5864 749
.code 3816 750
.code 7912 751
.code 488 752
.code 4584 753
.code 2536 754
.code 6632 755
.code 1512 756
.code 5608 757
.code 3560 758
.code 7656 759
.code 1000 760
.code 5096 761
.code 3048 762
.code 7144 763
.code 2024 764
.code 6120 765
.code 4072 766
.code 8168 767
.code 24 768
.code 4120 769
.code 2072 770
.code 6168 771
.code 1048 772
.code 5144 773
.code 3096 774
.code 7192 775
.code 536 776
.code 4632 777
.code 2584 778
.code 6680 779
.code 1560 780
.code 5656 781
.code 3608 782
.code 7704 783
.code 280 784
.code 4376 785
.code 2328 786
.code 6424 787
.code 1304 788
.code 5400 789
.code 3352 790
.code 7448 791
.code 792 792
.code 4888 793
.code 2840 794
.code 6936 795
.code 1816 796
.code 5912 797
.code 3864 798
.code 7960 799
.code 152 800
.code 4248 801
.code 2200 802
.code 6296 803
.code 1176 804
.code 5272 805
.code 3224 806
.code 7320 807
.code 664 808
.code 4760 809
.code 2712 810
.code 6808 811
.code 1688 812
.code 5784 813
.code 3736 814
.code 7832 815
.code 408 816
.code 4504 817
.code 2456 818
.code 6552 819
.code 1432 820
.code 5528 821
.code 3480 822
.code 7576 823
.code 920 824
.code 5016 825
.code 2968 826
.code 7064 827
.code 1944 828
.code 6040 829
.code 3992 830
.code 8088 831
.code 88 832
.code 4184 833
.code 2136 834
.code 6232 835
.code 1112 836
.code 5208 837
.code 3160 838
.code 7256 839
.code 600 840
.code 4696 841
.code 2648 842
.code 6744 843
.code 1624 844
.code 5720 845
.code 3672 846
.code 7768 847
.code 344 848
.code 4440 849
.code 2392 850
.code 6488 851
.code 1368 852
.code 5464 853
.code 3416 854
.code 7512 855
.code 856 856
.code 4952 857
.code 2904 858
.code 7000 859
.code 1880 860
.code 5976 861
.code 3928 862
.code 8024 863
.code 216 864
.code 4312 865
.code 2264 866
.code 6360 867
.code 1240 868
.code 5336 869
.code 3288 870
.code 7384 871
.code 728 872
.code 4824 873
.code 2776 874
.code 6872 875
.code 1752 876
.code 5848 877
.code 3800 878
.code 7896 879
.code 472 880
.code 4568 881
.code 2520 882
.code 6616 883
.code 1496 884
.code 5592 885
.code 3544 886
.code 7640 887
.code 984 888
.code 5080 889
.code 3032 890
.code 7128 891
.code 2008 892
.code 6104 893
.code 4056 894
.code 8152 895
.code 56 896
.code 4152 897
.code 2104 898
.code 6200 899
.code 1080 900
.code 5176 901
.code 3128 902
.code 7224 903
.code 568 904
.code 4664 905
.code 2616 906
.code 6712 907
.code 1592 908
.code 5688 909
.code 3640 910
.code 7736 911
.code 312 912
.code 4408 913
.code 2360 914
.code 6456 915
.code 1336 916
.code 5432 917
.code 3384 918
.code 7480 919
.code 824 920
.code 4920 921
.code 2872 922
.code 6968 923
.code 1848 924
.code 5944 925
.code 3896 926
.code 7992 927
.code 184 928
.code 4280 929
.code 2232 930
.code 6328 931
.code 1208 932
.code 5304 933
.code 3256 934
.code 7352 935
.code 696 936
.code 4792 937
.code 2744 938
.code 6840 939
.code 1720 940
.code 5816 941
.code 3768 942
.code 7864 943
.code 440 944
.code 4536 945
.code 2488 946
.code 6584 947
.code 1464 948
.code 5560 949
.code 3512 950
.code 7608 951
.code 952 952
.code 5048 953
.code 3000 954
.code 7096 955
.code 1976 956
.code 6072 957
.code 4024 958
.code 8120 959
.code 120 960
.code 4216 961
.code 2168 962
.code 6264 963
.code 1144 964
.code 5240 965
.code 3192 966
.code 7288 967
.code 632 968
.code 4728 969
.code 2680 970
.code 6776 971
.code 1656 972
.code 5752 973
.code 3704 974
.code 7800 975
.code 376 976
.code 4472 977
.code 2424 978
.code 6520 979
.code 1400 980
.code 5496 981
.code 3448 982
.code 7544 983
.code 888 984
.code 4984 985
.code 2936 986
.code 7032 987
.code 1912 988
.code 6008 989
.code 3960 990
.code 8056 991
.code 248 992
.code 4344 993
.code 2296 994
.code 6392 995
.code 1272 996
.code 5368 997
.code 3320 998
.code 7416 999
.code 760 1000
.code 4856 1001
.code 2808 1002
.code 6904 1003
.code 1784 1004
.code 5880 1005
.code 3832 1006
.code 7928 1007
.code 504 1008
.code 4600 1009
.code 2552 1010
.code 6648 1011
.code 1528 1012
.code 5624 1013
.code 3576 1014
.code 7672 1015
.code 1016 1016
.code 5112 1017
.code 3064 1018
.code 7160 1019
.code 2040 1020
.code 6136 1021
.code 4088 1022
.code 8184 1023
.code 4 1024
.code 4100 1025
.code 2052 1026
.code 6148 1027
.code 1028 1028
.code 5124 1029
.code 3076 1030
.code 7172 1031
.code 516 1032
.code 4612 1033
.code 2564 1034
.code 6660 1035
.code 1540 1036
.code 5636 1037
.code 3588 1038
.code 7684 1039
.code 260 1040
.code 4356 1041
.code 2308 1042
.code 6404 1043
.code 1284 1044
.code 5380 1045
.code 3332 1046
.code 7428 1047
.code 772 1048
.code 4868 1049
.code 2820 1050
.code 6916 1051
.code 1796 1052
.code 5892 1053
.code 3844 1054
.code 7940 1055
.code 132 1056
.code 4228 1057
.code 2180 1058
.code 6276 1059
.code 1156 1060
.code 5252 1061
.code 3204 1062
.code 7300 1063
.code 644 1064
.code 4740 1065
.code 2692 1066
.code 6788 1067
.code 1668 1068
.code 5764 1069
.code 3716 1070
.code 7812 1071
.code 388 1072
.code 4484 1073
.code 2436 1074
.code 6532 1075
.code 1412 1076
.code 5508 1077
.code 3460 1078
.code 7556 1079
.code 900 1080
.code 4996 1081
.code 2948 1082
.code 7044 1083
.code 1924 1084
.code 6020 1085
.code 3972 1086
.code 8068 1087
.code 68 1088
.code 4164 1089
.code 2116 1090
.code 6212 1091
.code 1092 1092
.code 5188 1093
.code 3140 1094
.code 7236 1095
.code 580 1096
.code 4676 1097
.code 2628 1098
.code 6724 1099
.code 1604 1100
.code 5700 1101
.code 3652 1102
.code 7748 1103
.code 324 1104
.code 4420 1105
.code 2372 1106
.code 6468 1107
.code 1348 1108
.code 5444 1109
.code 3396 1110
.code 7492 1111
.code 836 1112
.code 4932 1113
.code 2884 1114
.code 6980 1115
.code 1860 1116
.code 5956 1117
.code 3908 1118
.code 8004 1119
.code 196 1120
.code 4292 1121
.code 2244 1122
.code 6340 1123
.code 1220 1124
.code 5316 1125
.code 3268 1126
.code 7364 1127
.code 708 1128
.code 4804 1129
.code 2756 1130
.code 6852 1131
.code 1732 1132
.code 5828 1133
.code 3780 1134
.code 7876 1135
.code 452 1136
.code 4548 1137
.code 2500 1138
.code 6596 1139
.code 1476 1140
.code 5572 1141
.code 3524 1142
.code 7620 1143
.code 964 1144
.code 5060 1145
.code 3012 1146
.code 7108 1147
.code 1988 1148
.code 6084 1149
.code 4036 1150
.code 8132 1151
.code 36 1152
.code 4132 1153
.code 2084 1154
.code 6180 1155
.code 1060 1156
.code 5156 1157
.code 3108 1158
.code 7204 1159
.code 548 1160
.code 4644 1161
.code 2596 1162
.code 6692 1163
.code 1572 1164
.code 5668 1165
.code 3620 1166
.code 7716 1167
.code 292 1168
.code 4388 1169
.code 2340 1170
.code 6436 1171
.code 1316 1172
.code 5412 1173
.code 3364 1174
.code 7460 1175
.code 804 1176
.code 4900 1177
.code 2852 1178
.code 6948 1179
.code 1828 1180
.code 5924 1181
.code 3876 1182
.code 7972 1183
.code 164 1184
.code 4260 1185
.code 2212 1186
.code 6308 1187
.code 1188 1188
.code 5284 1189
.code 3236 1190
.code 7332 1191
.code 676 1192
.code 4772 1193
.code 2724 1194
.code 6820 1195
.code 1700 1196
.code 5796 1197
.code 3748 1198
.code 7844 1199
.code 420 1200
.code 4516 1201
.code 2468 1202
.code 6564 1203
.code 1444 1204
.code 5540 1205
.code 3492 1206
.code 7588 1207
.code 932 1208
.code 5028 1209
.code 2980 1210
.code 7076 1211
.code 1956 1212
.code 6052 1213
.code 4004 1214
.code 8100 1215
.code 100 1216
.code 4196 1217
.code 2148 1218
.code 6244 1219
.code 1124 1220
.code 5220 1221
.code 3172 1222
.code 7268 1223
.code 612 1224
.code 4708 1225
.code 2660 1226
.code 6756 1227
.code 1636 1228
.code 5732 1229
.code 3684 1230
.code 7780 1231
.code 356 1232
.code 4452 1233
.code 2404 1234
.code 6500 1235
.code 1380 1236
.code 5476 1237
.code 3428 1238
.code 7524 1239
.code 868 1240
.code 4964 1241
.code 2916 1242
.code 7012 1243
.code 1892 1244
.code 5988 1245
.code 3940 1246
.code 8036 1247
.code 228 1248
.code 4324 1249
.code 2276 1250
.code 6372 1251
.code 1252 1252
.code 5348 1253
.code 3300 1254
.code 7396 1255
.code 740 1256
.code 4836 1257
.code 2788 1258
.code 6884 1259
.code 1764 1260
.code 5860 1261
.code 3812 1262
.code 7908 1263
.code 484 1264
.code 4580 1265
.code 2532 1266
.code 6628 1267
.code 1508 1268
.code 5604 1269
.code 3556 1270
.code 7652 1271
.code 996 1272
.code 5092 1273
.code 3044 1274
.code 7140 1275
.code 2020 1276
.code 6116 1277
.code 4068 1278
.code 8164 1279
.code 20 1280
.code 4116 1281
.code 2068 1282
.code 6164 1283
.code 1044 1284
.code 5140 1285
.code 3092 1286
.code 7188 1287
.code 532 1288
.code 4628 1289
.code 2580 1290
.code 6676 1291
.code 1556 1292
.code 5652 1293
.code 3604 1294
.code 7700 1295
.code 276 1296
.code 4372 1297
.code 2324 1298
.code 6420 1299
.code 1300 1300
.code 5396 1301
.code 3348 1302
.code 7444 1303
.code 788 1304
.code 4884 1305
.code 2836 1306
.code 6932 1307
.code 1812 1308
.code 5908 1309
.code 3860 1310
.code 7956 1311
.code 148 1312
.code 4244 1313
.code 2196 1314
.code 6292 1315
.code 1172 1316
.code 5268 1317
.code 3220 1318
.code 7316 1319
.code 660 1320
.code 4756 1321
.code 2708 1322
.code 6804 1323
.code 1684 1324
.code 5780 1325
.code 3732 1326
.code 7828 1327
.code 404 1328
.code 4500 1329
.code 2452 1330
.code 6548 1331
.code 1428 1332
.code 5524 1333
.code 3476 1334
.code 7572 1335
.code 916 1336
.code 5012 1337
.code 2964 1338
.code 7060 1339
.code 1940 1340
.code 6036 1341
.code 3988 1342
.code 8084 1343
.code 84 1344
.code 4180 1345
.code 2132 1346
.code 6228 1347
.code 1108 1348
.code 5204 1349
.code 3156 1350
.code 7252 1351
.code 596 1352
.code 4692 1353
.code 2644 1354
.code 6740 1355
.code 1620 1356
.code 5716 1357
.code 3668 1358
.code 7764 1359
.code 340 1360
.code 4436 1361
.code 2388 1362
.code 6484 1363
.code 1364 1364
.code 5460 1365
.code 3412 1366
.code 7508 1367
.code 852 1368
.code 4948 1369
.code 2900 1370
.code 6996 1371
.code 1876 1372
.code 5972 1373
.code 3924 1374
.code 8020 1375
.code 212 1376
.code 4308 1377
.code 2260 1378
.code 6356 1379
.code 1236 1380
.code 5332 1381
.code 3284 1382
.code 7380 1383
.code 724 1384
.code 4820 1385
.code 2772 1386
.code 6868 1387
.code 1748 1388
.code 5844 1389
.code 3796 1390
.code 7892 1391
.code 468 1392
.code 4564 1393
.code 2516 1394
.code 6612 1395
.code 1492 1396
.code 5588 1397
.code 3540 1398
.code 7636 1399
.code 980 1400
.code 5076 1401
.code 3028 1402
.code 7124 1403
.code 2004 1404
.code 6100 1405
.code 4052 1406
.code 8148 1407
.code 52 1408
.code 4148 1409
.code 2100 1410
.code 6196 1411
.code 1076 1412
.code 5172 1413
.code 3124 1414
.code 7220 1415
.code 564 1416
.code 4660 1417
.code 2612 1418
.code 6708 1419
.code 1588 1420
.code 5684 1421
.code 3636 1422
.code 7732 1423
.code 308 1424
.code 4404 1425
.code 2356 1426
.code 6452 1427
.code 1332 1428
.code 5428 1429
.code 3380 1430
.code 7476 1431
.code 820 1432
.code 4916 1433
.code 2868 1434
.code 6964 1435
.code 1844 1436
.code 5940 1437
.code 3892 1438
.code 7988 1439
.code 180 1440
.code 4276 1441
.code 2228 1442
.code 6324 1443
.code 1204 1444
.code 5300 1445
.code 3252 1446
.code 7348 1447
.code 692 1448
.code 4788 1449
.code 2740 1450
.code 6836 1451
.code 1716 1452
.code 5812 1453
.code 3764 1454
.code 7860 1455
.code 436 1456
.code 4532 1457
.code 2484 1458
.code 6580 1459
.code 1460 1460
.code 5556 1461
.code 3508 1462
.code 7604 1463
.code 948 1464
.code 5044 1465
.code 2996 1466
.code 7092 1467
.code 1972 1468
.code 6068 1469
.code 4020 1470
.code 8116 1471
.code 116 1472
.code 4212 1473
.code 2164 1474
.code 6260 1475
.code 1140 1476
.code 5236 1477
.code 3188 1478
.code 7284 1479
.code 628 1480
.code 4724 1481
.code 2676 1482
.code 6772 1483
.code 1652 1484
.code 5748 1485
.code 3700 1486
.code 7796 1487
.code 372 1488
.code 4468 1489
.code 2420 1490
.code 6516 1491
.code 1396 1492
.code 5492 1493
.code 3444 1494
.code 7540 1495
.code 884 1496
.code 4980 1497
.code 2932 1498
.code 7028 1499
.code 1908 1500
.code 6004 1501
.code 3956 1502
.code 8052 1503
.code 244 1504
.code 4340 1505
.code 2292 1506
.code 6388 1507
.code 1268 1508
.code 5364 1509
.code 3316 1510
.code 7412 1511
.code 756 1512
.code 4852 1513
.code 2804 1514
.code 6900 1515
.code 1780 1516
.code 5876 1517
.code 3828 1518
.code 7924 1519
.code 500 1520
.code 4596 1521
.code 2548 1522
.code 6644 1523
.code 1524 1524
.code 5620 1525
.code 3572 1526
.code 7668 1527
.code 1012 1528
.code 5108 1529
.code 3060 1530
.code 7156 1531
.code 2036 1532
.code 6132 1533
.code 4084 1534
.code 8180 1535
.code 12 1536
.code 4108 1537
.code 2060 1538
.code 6156 1539
.code 1036 1540
.code 5132 1541
.code 3084 1542
.code 7180 1543
.code 524 1544
.code 4620 1545
.code 2572 1546
.code 6668 1547
.code 1548 1548
.code 5644 1549
.code 3596 1550
.code 7692 1551
.code 268 1552
.code 4364 1553
.code 2316 1554
.code 6412 1555
.code 1292 1556
.code 5388 1557
.code 3340 1558
.code 7436 1559
.code 780 1560
.code 4876 1561
.code 2828 1562
.code 6924 1563
.code 1804 1564
.code 5900 1565
.code 3852 1566
.code 7948 1567
.code 140 1568
.code 4236 1569
.code 2188 1570
.code 6284 1571
.code 1164 1572
.code 5260 1573
.code 3212 1574
.code 7308 1575
.code 652 1576
.code 4748 1577
.code 2700 1578
.code 6796 1579
.code 1676 1580
.code 5772 1581
.code 3724 1582
.code 7820 1583
.code 396 1584
.code 4492 1585
.code 2444 1586
.code 6540 1587
.code 1420 1588
.code 5516 1589
.code 3468 1590
.code 7564 1591
.code 908 1592
.code 5004 1593
.code 2956 1594
.code 7052 1595
.code 1932 1596
.code 6028 1597
.code 3980 1598
.code 8076 1599
.code 76 1600
.code 4172 1601
.code 2124 1602
.code 6220 1603
.code 1100 1604
.code 5196 1605
.code 3148 1606
.code 7244 1607
.code 588 1608
.code 4684 1609
.code 2636 1610
.code 6732 1611
.code 1612 1612
.code 5708 1613
.code 3660 1614
.code 7756 1615
.code 332 1616
.code 4428 1617
.code 2380 1618
.code 6476 1619
.code 1356 1620
.code 5452 1621
.code 3404 1622
.code 7500 1623
.code 844 1624
.code 4940 1625
.code 2892 1626
.code 6988 1627
.code 1868 1628
.code 5964 1629
.code 3916 1630
.code 8012 1631
.code 204 1632
.code 4300 1633
.code 2252 1634
.code 6348 1635
.code 1228 1636
.code 5324 1637
.code 3276 1638
.code 7372 1639
.code 716 1640
.code 4812 1641
.code 2764 1642
.code 6860 1643
.code 1740 1644
.code 5836 1645
.code 3788 1646
.code 7884 1647
.code 460 1648
.code 4556 1649
.code 2508 1650
.code 6604 1651
.code 1484 1652
.code 5580 1653
.code 3532 1654
.code 7628 1655
.code 972 1656
.code 5068 1657
.code 3020 1658
.code 7116 1659
.code 1996 1660
.code 6092 1661
.code 4044 1662
.code 8140 1663
.code 44 1664
.code 4140 1665
.code 2092 1666
.code 6188 1667
.code 1068 1668
.code 5164 1669
.code 3116 1670
.code 7212 1671
.code 556 1672
.code 4652 1673
.code 2604 1674
.code 6700 1675
.code 1580 1676
.code 5676 1677
.code 3628 1678
.code 7724 1679
.code 300 1680
.code 4396 1681
.code 2348 1682
.code 6444 1683
.code 1324 1684
.code 5420 1685
.code 3372 1686
.code 7468 1687
.code 812 1688
.code 4908 1689
.code 2860 1690
.code 6956 1691
.code 1836 1692
.code 5932 1693
.code 3884 1694
.code 7980 1695
.code 172 1696
.code 4268 1697
.code 2220 1698
.code 6316 1699
.code 1196 1700
.code 5292 1701
.code 3244 1702
.code 7340 1703
.code 684 1704
.code 4780 1705
.code 2732 1706
.code 6828 1707
.code 1708 1708
.code 5804 1709
.code 3756 1710
.code 7852 1711
.code 428 1712
.code 4524 1713
.code 2476 1714
.code 6572 1715
.code 1452 1716
.code 5548 1717
.code 3500 1718
.code 7596 1719
.code 940 1720
.code 5036 1721
.code 2988 1722
.code 7084 1723
.code 1964 1724
.code 6060 1725
.code 4012 1726
.code 8108 1727
.code 108 1728
.code 4204 1729
.code 2156 1730
.code 6252 1731
.code 1132 1732
.code 5228 1733
.code 3180 1734
.code 7276 1735
.code 620 1736
.code 4716 1737
.code 2668 1738
.code 6764 1739
.code 1644 1740
.code 5740 1741
.code 3692 1742
.code 7788 1743
.code 364 1744
.code 4460 1745
.code 2412 1746
.code 6508 1747
.code 1388 1748
.code 5484 1749
.code 3436 1750
.code 7532 1751
.code 876 1752
.code 4972 1753
.code 2924 1754
.code 7020 1755
.code 1900 1756
.code 5996 1757
.code 3948 1758
.code 8044 1759
.code 236 1760
.code 4332 1761
.code 2284 1762
.code 6380 1763
.code 1260 1764
.code 5356 1765
.code 3308 1766
.code 7404 1767
.code 748 1768
.code 4844 1769
.code 2796 1770
.code 6892 1771
.code 1772 1772
.code 5868 1773
.code 3820 1774
.code 7916 1775
.code 492 1776
.code 4588 1777
.code 2540 1778
.code 6636 1779
.code 1516 1780
.code 5612 1781
.code 3564 1782
.code 7660 1783
.code 1004 1784
.code 5100 1785
.code 3052 1786
.code 7148 1787
.code 2028 1788
.code 6124 1789
.code 4076 1790
.code 8172 1791
.code 28 1792
.code 4124 1793
.code 2076 1794
.code 6172 1795
.code 1052 1796
.code 5148 1797
.code 3100 1798
.code 7196 1799
.code 540 1800
.code 4636 1801
.code 2588 1802
.code 6684 1803
.code 1564 1804
.code 5660 1805
.code 3612 1806
.code 7708 1807
.code 284 1808
.code 4380 1809
.code 2332 1810
.code 6428 1811
.code 1308 1812
.code 5404 1813
.code 3356 1814
.code 7452 1815
.code 796 1816
.code 4892 1817
.code 2844 1818
.code 6940 1819
.code 1820 1820
.code 5916 1821
.code 3868 1822
.code 7964 1823
.code 156 1824
.code 4252 1825
.code 2204 1826
.code 6300 1827
.code 1180 1828
.code 5276 1829
.code 3228 1830
.code 7324 1831
.code 668 1832
.code 4764 1833
.code 2716 1834
.code 6812 1835
.code 1692 1836
.code 5788 1837
.code 3740 1838
.code 7836 1839
.code 412 1840
.code 4508 1841
.code 2460 1842
.code 6556 1843
.code 1436 1844
.code 5532 1845
.code 3484 1846
.code 7580 1847
.code 924 1848
.code 5020 1849
.code 2972 1850
.code 7068 1851
.code 1948 1852
.code 6044 1853
.code 3996 1854
.code 8092 1855
.code 92 1856
.code 4188 1857
.code 2140 1858
.code 6236 1859
.code 1116 1860
.code 5212 1861
.code 3164 1862
.code 7260 1863
.code 604 1864
.code 4700 1865
.code 2652 1866
.code 6748 1867
.code 1628 1868
.code 5724 1869
.code 3676 1870
.code 7772 1871
.code 348 1872
.code 4444 1873
.code 2396 1874
.code 6492 1875
.code 1372 1876
.code 5468 1877
.code 3420 1878
.code 7516 1879
.code 860 1880
.code 4956 1881
.code 2908 1882
.code 7004 1883
.code 1884 1884
.code 5980 1885
.code 3932 1886
.code 8028 1887
.code 220 1888
.code 4316 1889
.code 2268 1890
.code 6364 1891
.code 1244 1892
.code 5340 1893
.code 3292 1894
.code 7388 1895
.code 732 1896
.code 4828 1897
.code 2780 1898
.code 6876 1899
.code 1756 1900
.code 5852 1901
.code 3804 1902
.code 7900 1903
.code 476 1904
.code 4572 1905
.code 2524 1906
.code 6620 1907
.code 1500 1908
.code 5596 1909
.code 3548 1910
.code 7644 1911
.code 988 1912
.code 5084 1913
.code 3036 1914
.code 7132 1915
.code 2012 1916
.code 6108 1917
.code 4060 1918
.code 8156 1919
.code 60 1920
.code 4156 1921
.code 2108 1922
.code 6204 1923
.code 1084 1924
.code 5180 1925
.code 3132 1926
.code 7228 1927
.code 572 1928
.code 4668 1929
.code 2620 1930
.code 6716 1931
.code 1596 1932
.code 5692 1933
.code 3644 1934
.code 7740 1935
.code 316 1936
.code 4412 1937
.code 2364 1938
.code 6460 1939
.code 1340 1940
.code 5436 1941
.code 3388 1942
.code 7484 1943
.code 828 1944
.code 4924 1945
.code 2876 1946
.code 6972 1947
.code 1852 1948
.code 5948 1949
.code 3900 1950
.code 7996 1951
.code 188 1952
.code 4284 1953
.code 2236 1954
.code 6332 1955
.code 1212 1956
.code 5308 1957
.code 3260 1958
.code 7356 1959
.code 700 1960
.code 4796 1961
.code 2748 1962
.code 6844 1963
.code 1724 1964
.code 5820 1965
.code 3772 1966
.code 7868 1967
.code 444 1968
.code 4540 1969
.code 2492 1970
.code 6588 1971
.code 1468 1972
.code 5564 1973
.code 3516 1974
.code 7612 1975
.code 956 1976
.code 5052 1977
.code 3004 1978
.code 7100 1979
.code 1980 1980
.code 6076 1981
.code 4028 1982
.code 8124 1983
.code 124 1984
.code 4220 1985
.code 2172 1986
.code 6268 1987
.code 1148 1988
.code 5244 1989
.code 3196 1990
.code 7292 1991
.code 636 1992
.code 4732 1993
.code 2684 1994
.code 6780 1995
.code 1660 1996
.code 5756 1997
.code 3708 1998
.code 7804 1999
.code 380 2000
.code 4476 2001
.code 2428 2002
.code 6524 2003
.code 1404 2004
.code 5500 2005
.code 3452 2006
.code 7548 2007
.code 892 2008
.code 4988 2009
.code 2940 2010
.code 7036 2011
.code 1916 2012
.code 6012 2013
.code 3964 2014
.code 8060 2015
.code 252 2016
.code 4348 2017
.code 2300 2018
.code 6396 2019
.code 1276 2020
.code 5372 2021
.code 3324 2022
.code 7420 2023
.code 764 2024
.code 4860 2025
.code 2812 2026
.code 6908 2027
.code 1788 2028
.code 5884 2029
.code 3836 2030
.code 7932 2031
.code 508 2032
.code 4604 2033
.code 2556 2034
.code 6652 2035
.code 1532 2036
.code 5628 2037
.code 3580 2038
.code 7676 2039
.code 1020 2040
.code 5116 2041
.code 3068 2042
.code 7164 2043
.code 2044 2044
.code 6140 2045
.code 4092 2046
.code 8188 2047
.code 2 2048
.code 4098 2049
.code 2050 2050
.code 6146 2051
.code 1026 2052
.code 5122 2053
.code 3074 2054
.code 7170 2055
.code 514 2056
.code 4610 2057
.code 2562 2058
.code 6658 2059
.code 1538 2060
.code 5634 2061
.code 3586 2062
.code 7682 2063
.code 258 2064
.code 4354 2065
.code 2306 2066
.code 6402 2067
.code 1282 2068
.code 5378 2069
.code 3330 2070
.code 7426 2071
.code 770 2072
.code 4866 2073
.code 2818 2074
.code 6914 2075
.code 1794 2076
.code 5890 2077
.code 3842 2078
.code 7938 2079
.code 130 2080
.code 4226 2081
.code 2178 2082
.code 6274 2083
.code 1154 2084
.code 5250 2085
.code 3202 2086
.code 7298 2087
.code 642 2088
.code 4738 2089
.code 2690 2090
.code 6786 2091
.code 1666 2092
.code 5762 2093
.code 3714 2094
.code 7810 2095
.code 386 2096
.code 4482 2097
.code 2434 2098
.code 6530 2099
.code 1410 2100
.code 5506 2101
.code 3458 2102
.code 7554 2103
.code 898 2104
.code 4994 2105
.code 2946 2106
.code 7042 2107
.code 1922 2108
.code 6018 2109
.code 3970 2110
.code 8066 2111
.code 66 2112
.code 4162 2113
.code 2114 2114
.code 6210 2115
.code 1090 2116
.code 5186 2117
.code 3138 2118
.code 7234 2119
.code 578 2120
.code 4674 2121
.code 2626 2122
.code 6722 2123
.code 1602 2124
.code 5698 2125
.code 3650 2126
.code 7746 2127
.code 322 2128
.code 4418 2129
.code 2370 2130
.code 6466 2131
.code 1346 2132
.code 5442 2133
.code 3394 2134
.code 7490 2135
.code 834 2136
.code 4930 2137
.code 2882 2138
.code 6978 2139
.code 1858 2140
.code 5954 2141
.code 3906 2142
.code 8002 2143
.code 194 2144
.code 4290 2145
.code 2242 2146
.code 6338 2147
.code 1218 2148
.code 5314 2149
.code 3266 2150
.code 7362 2151
.code 706 2152
.code 4802 2153
.code 2754 2154
.code 6850 2155
.code 1730 2156
.code 5826 2157
.code 3778 2158
.code 7874 2159
.code 450 2160
.code 4546 2161
.code 2498 2162
.code 6594 2163
.code 1474 2164
.code 5570 2165
.code 3522 2166
.code 7618 2167
.code 962 2168
.code 5058 2169
.code 3010 2170
.code 7106 2171
.code 1986 2172
.code 6082 2173
.code 4034 2174
.code 8130 2175
.code 34 2176
.code 4130 2177
.code 2082 2178
.code 6178 2179
.code 1058 2180
.code 5154 2181
.code 3106 2182
.code 7202 2183
.code 546 2184
.code 4642 2185
.code 2594 2186
.code 6690 2187
.code 1570 2188
.code 5666 2189
.code 3618 2190
.code 7714 2191
.code 290 2192
.code 4386 2193
.code 2338 2194
.code 6434 2195
.code 1314 2196
.code 5410 2197
.code 3362 2198
.code 7458 2199
.code 802 2200
.code 4898 2201
.code 2850 2202
.code 6946 2203
.code 1826 2204
.code 5922 2205
.code 3874 2206
.code 7970 2207
.code 162 2208
.code 4258 2209
.code 2210 2210
.code 6306 2211
.code 1186 2212
.code 5282 2213
.code 3234 2214
.code 7330 2215
.code 674 2216
.code 4770 2217
.code 2722 2218
.code 6818 2219
.code 1698 2220
.code 5794 2221
.code 3746 2222
.code 7842 2223
.code 418 2224
.code 4514 2225
.code 2466 2226
.code 6562 2227
.code 1442 2228
.code 5538 2229
.code 3490 2230
.code 7586 2231
.code 930 2232
.code 5026 2233
.code 2978 2234
.code 7074 2235
.code 1954 2236
.code 6050 2237
.code 4002 2238
.code 8098 2239
.code 98 2240
.code 4194 2241
.code 2146 2242
.code 6242 2243
.code 1122 2244
.code 5218 2245
.code 3170 2246
.code 7266 2247
.code 610 2248
.code 4706 2249
.code 2658 2250
.code 6754 2251
.code 1634 2252
.code 5730 2253
.code 3682 2254
.code 7778 2255
.code 354 2256
.code 4450 2257
.code 2402 2258
.code 6498 2259
.code 1378 2260
.code 5474 2261
.code 3426 2262
.code 7522 2263
.code 866 2264
.code 4962 2265
.code 2914 2266
.code 7010 2267
.code 1890 2268
.code 5986 2269
.code 3938 2270
.code 8034 2271
.code 226 2272
.code 4322 2273
.code 2274 2274
.code 6370 2275
.code 1250 2276
.code 5346 2277
.code 3298 2278
.code 7394 2279
.code 738 2280
.code 4834 2281
.code 2786 2282
.code 6882 2283
.code 1762 2284
.code 5858 2285
.code 3810 2286
.code 7906 2287
.code 482 2288
.code 4578 2289
.code 2530 2290
.code 6626 2291
.code 1506 2292
.code 5602 2293
.code 3554 2294
.code 7650 2295
.code 994 2296
.code 5090 2297
.code 3042 2298
.code 7138 2299
.code 2018 2300
.code 6114 2301
.code 4066 2302
.code 8162 2303
.code 18 2304
.code 4114 2305
.code 2066 2306
.code 6162 2307
.code 1042 2308
.code 5138 2309
.code 3090 2310
.code 7186 2311
.code 530 2312
.code 4626 2313
.code 2578 2314
.code 6674 2315
.code 1554 2316
.code 5650 2317
.code 3602 2318
.code 7698 2319
.code 274 2320
.code 4370 2321
.code 2322 2322
.code 6418 2323
.code 1298 2324
.code 5394 2325
.code 3346 2326
.code 7442 2327
.code 786 2328
.code 4882 2329
.code 2834 2330
.code 6930 2331
.code 1810 2332
.code 5906 2333
.code 3858 2334
.code 7954 2335
.code 146 2336
.code 4242 2337
.code 2194 2338
.code 6290 2339
.code 1170 2340
.code 5266 2341
.code 3218 2342
.code 7314 2343
.code 658 2344
.code 4754 2345
.code 2706 2346
.code 6802 2347
.code 1682 2348
.code 5778 2349
.code 3730 2350
.code 7826 2351
.code 402 2352
.code 4498 2353
.code 2450 2354
.code 6546 2355
.code 1426 2356
.code 5522 2357
.code 3474 2358
.code 7570 2359
.code 914 2360
.code 5010 2361
.code 2962 2362
.code 7058 2363
.code 1938 2364
.code 6034 2365
.code 3986 2366
.code 8082 2367
.code 82 2368
.code 4178 2369
.code 2130 2370
.code 6226 2371
.code 1106 2372
.code 5202 2373
.code 3154 2374
.code 7250 2375
.code 594 2376
.code 4690 2377
.code 2642 2378
.code 6738 2379
.code 1618 2380
.code 5714 2381
.code 3666 2382
.code 7762 2383
.code 338 2384
.code 4434 2385
.code 2386 2386
.code 6482 2387
.code 1362 2388
.code 5458 2389
.code 3410 2390
.code 7506 2391
.code 850 2392
.code 4946 2393
.code 2898 2394
.code 6994 2395
.code 1874 2396
.code 5970 2397
.code 3922 2398
.code 8018 2399
.code 210 2400
.code 4306 2401
.code 2258 2402
.code 6354 2403
.code 1234 2404
.code 5330 2405
.code 3282 2406
.code 7378 2407
.code 722 2408
.code 4818 2409
.code 2770 2410
.code 6866 2411
.code 1746 2412
.code 5842 2413
.code 3794 2414
.code 7890 2415
.code 466 2416
.code 4562 2417
.code 2514 2418
.code 6610 2419
.code 1490 2420
.code 5586 2421
.code 3538 2422
.code 7634 2423
.code 978 2424
.code 5074 2425
.code 3026 2426
.code 7122 2427
.code 2002 2428
.code 6098 2429
.code 4050 2430
.code 8146 2431
.code 50 2432
.code 4146 2433
.code 2098 2434
.code 6194 2435
.code 1074 2436
.code 5170 2437
.code 3122 2438
.code 7218 2439
.code 562 2440
.code 4658 2441
.code 2610 2442
.code 6706 2443
.code 1586 2444
.code 5682 2445
.code 3634 2446
.code 7730 2447
.code 306 2448
.code 4402 2449
.code 2354 2450
.code 6450 2451
.code 1330 2452
.code 5426 2453
.code 3378 2454
.code 7474 2455
.code 818 2456
.code 4914 2457
.code 2866 2458
.code 6962 2459
.code 1842 2460
.code 5938 2461
.code 3890 2462
.code 7986 2463
.code 178 2464
.code 4274 2465
.code 2226 2466
.code 6322 2467
.code 1202 2468
.code 5298 2469
.code 3250 2470
.code 7346 2471
.code 690 2472
.code 4786 2473
.code 2738 2474
.code 6834 2475
.code 1714 2476
.code 5810 2477
.code 3762 2478
.code 7858 2479
.code 434 2480
.code 4530 2481
.code 2482 2482
.code 6578 2483
.code 1458 2484
.code 5554 2485
.code 3506 2486
.code 7602 2487
.code 946 2488
.code 5042 2489
.code 2994 2490
.code 7090 2491
.code 1970 2492
.code 6066 2493
.code 4018 2494
.code 8114 2495
.code 114 2496
.code 4210 2497
.code 2162 2498
.code 6258 2499
.code 1138 2500
.code 5234 2501
.code 3186 2502
.code 7282 2503
.code 626 2504
.code 4722 2505
.code 2674 2506
.code 6770 2507
.code 1650 2508
.code 5746 2509
.code 3698 2510
.code 7794 2511
.code 370 2512
.code 4466 2513
.code 2418 2514
.code 6514 2515
.code 1394 2516
.code 5490 2517
.code 3442 2518
.code 7538 2519
.code 882 2520
.code 4978 2521
.code 2930 2522
.code 7026 2523
.code 1906 2524
.code 6002 2525
.code 3954 2526
.code 8050 2527
.code 242 2528
.code 4338 2529
.code 2290 2530
.code 6386 2531
.code 1266 2532
.code 5362 2533
.code 3314 2534
.code 7410 2535
.code 754 2536
.code 4850 2537
.code 2802 2538
.code 6898 2539
.code 1778 2540
.code 5874 2541
.code 3826 2542
.code 7922 2543
.code 498 2544
.code 4594 2545
.code 2546 2546
.code 6642 2547
.code 1522 2548
.code 5618 2549
.code 3570 2550
.code 7666 2551
.code 1010 2552
.code 5106 2553
.code 3058 2554
.code 7154 2555
.code 2034 2556
.code 6130 2557
.code 4082 2558
.code 8178 2559
.code 10 2560
.code 4106 2561
.code 2058 2562
.code 6154 2563
.code 1034 2564
.code 5130 2565
.code 3082 2566
.code 7178 2567
.code 522 2568
.code 4618 2569
.code 2570 2570
.code 6666 2571
.code 1546 2572
.code 5642 2573
.code 3594 2574
.code 7690 2575
.code 266 2576
.code 4362 2577
.code 2314 2578
.code 6410 2579
.code 1290 2580
.code 5386 2581
.code 3338 2582
.code 7434 2583
.code 778 2584
.code 4874 2585
.code 2826 2586
.code 6922 2587
.code 1802 2588
.code 5898 2589
.code 3850 2590
.code 7946 2591
.code 138 2592
.code 4234 2593
.code 2186 2594
.code 6282 2595
.code 1162 2596
.code 5258 2597
.code 3210 2598
.code 7306 2599
.code 650 2600
.code 4746 2601
.code 2698 2602
.code 6794 2603
.code 1674 2604
.code 5770 2605
.code 3722 2606
.code 7818 2607
.code 394 2608
.code 4490 2609
.code 2442 2610
.code 6538 2611
.code 1418 2612
.code 5514 2613
.code 3466 2614
.code 7562 2615
.code 906 2616
.code 5002 2617
.code 2954 2618
.code 7050 2619
.code 1930 2620
.code 6026 2621
.code 3978 2622
.code 8074 2623
.code 74 2624
.code 4170 2625
.code 2122 2626
.code 6218 2627
.code 1098 2628
.code 5194 2629
.code 3146 2630
.code 7242 2631
.code 586 2632
.code 4682 2633
.code 2634 2634
.code 6730 2635
.code 1610 2636
.code 5706 2637
.code 3658 2638
.code 7754 2639
.code 330 2640
.code 4426 2641
.code 2378 2642
.code 6474 2643
.code 1354 2644
.code 5450 2645
.code 3402 2646
.code 7498 2647
.code 842 2648
.code 4938 2649
.code 2890 2650
.code 6986 2651
.code 1866 2652
.code 5962 2653
.code 3914 2654
.code 8010 2655
.code 202 2656
.code 4298 2657
.code 2250 2658
.code 6346 2659
.code 1226 2660
.code 5322 2661
.code 3274 2662
.code 7370 2663
.code 714 2664
.code 4810 2665
.code 2762 2666
.code 6858 2667
.code 1738 2668
.code 5834 2669
.code 3786 2670
.code 7882 2671
.code 458 2672
.code 4554 2673
.code 2506 2674
.code 6602 2675
.code 1482 2676
.code 5578 2677
.code 3530 2678
.code 7626 2679
.code 970 2680
.code 5066 2681
.code 3018 2682
.code 7114 2683
.code 1994 2684
.code 6090 2685
.code 4042 2686
.code 8138 2687
.code 42 2688
.code 4138 2689
.code 2090 2690
.code 6186 2691
.code 1066 2692
.code 5162 2693
.code 3114 2694
.code 7210 2695
.code 554 2696
.code 4650 2697
.code 2602 2698
.code 6698 2699
.code 1578 2700
.code 5674 2701
.code 3626 2702
.code 7722 2703
.code 298 2704
.code 4394 2705
.code 2346 2706
.code 6442 2707
.code 1322 2708
.code 5418 2709
.code 3370 2710
.code 7466 2711
.code 810 2712
.code 4906 2713
.code 2858 2714
.code 6954 2715
.code 1834 2716
.code 5930 2717
.code 3882 2718
.code 7978 2719
.code 170 2720
.code 4266 2721
.code 2218 2722
.code 6314 2723
.code 1194 2724
.code 5290 2725
.code 3242 2726
.code 7338 2727
.code 682 2728
.code 4778 2729
.code 2730 2730
.code 6826 2731
.code 1706 2732
.code 5802 2733
.code 3754 2734
.code 7850 2735
.code 426 2736
.code 4522 2737
.code 2474 2738
.code 6570 2739
.code 1450 2740
.code 5546 2741
.code 3498 2742
.code 7594 2743
.code 938 2744
.code 5034 2745
.code 2986 2746
.code 7082 2747
.code 1962 2748
.code 6058 2749
.code 4010 2750
.code 8106 2751
.code 106 2752
.code 4202 2753
.code 2154 2754
.code 6250 2755
.code 1130 2756
.code 5226 2757
.code 3178 2758
.code 7274 2759
.code 618 2760
.code 4714 2761
.code 2666 2762
.code 6762 2763
.code 1642 2764
.code 5738 2765
.code 3690 2766
.code 7786 2767
.code 362 2768
.code 4458 2769
.code 2410 2770
.code 6506 2771
.code 1386 2772
.code 5482 2773
.code 3434 2774
.code 7530 2775
.code 874 2776
.code 4970 2777
.code 2922 2778
.code 7018 2779
.code 1898 2780
.code 5994 2781
.code 3946 2782
.code 8042 2783
.code 234 2784
.code 4330 2785
.code 2282 2786
.code 6378 2787
.code 1258 2788
.code 5354 2789
.code 3306 2790
.code 7402 2791
.code 746 2792
.code 4842 2793
.code 2794 2794
.code 6890 2795
.code 1770 2796
.code 5866 2797
.code 3818 2798
.code 7914 2799
.code 490 2800
.code 4586 2801
.code 2538 2802
.code 6634 2803
.code 1514 2804
.code 5610 2805
.code 3562 2806
.code 7658 2807
.code 1002 2808
.code 5098 2809
.code 3050 2810
.code 7146 2811
.code 2026 2812
.code 6122 2813
.code 4074 2814
.code 8170 2815
.code 26 2816
.code 4122 2817
.code 2074 2818
.code 6170 2819
.code 1050 2820
.code 5146 2821
.code 3098 2822
.code 7194 2823
.code 538 2824
.code 4634 2825
.code 2586 2826
.code 6682 2827
.code 1562 2828
.code 5658 2829
.code 3610 2830
.code 7706 2831
.code 282 2832
.code 4378 2833
.code 2330 2834
.code 6426 2835
.code 1306 2836
.code 5402 2837
.code 3354 2838
.code 7450 2839
.code 794 2840
.code 4890 2841
.code 2842 2842
.code 6938 2843
.code 1818 2844
.code 5914 2845
.code 3866 2846
.code 7962 2847
.code 154 2848
.code 4250 2849
.code 2202 2850
.code 6298 2851
.code 1178 2852
.code 5274 2853
.code 3226 2854
.code 7322 2855
.code 666 2856
.code 4762 2857
.code 2714 2858
.code 6810 2859
.code 1690 2860
.code 5786 2861
.code 3738 2862
.code 7834 2863
.code 410 2864
.code 4506 2865
.code 2458 2866
.code 6554 2867
.code 1434 2868
.code 5530 2869
.code 3482 2870
.code 7578 2871
.code 922 2872
.code 5018 2873
.code 2970 2874
.code 7066 2875
.code 1946 2876
.code 6042 2877
.code 3994 2878
.code 8090 2879
.code 90 2880
.code 4186 2881
.code 2138 2882
.code 6234 2883
.code 1114 2884
.code 5210 2885
.code 3162 2886
.code 7258 2887
.code 602 2888
.code 4698 2889
.code 2650 2890
.code 6746 2891
.code 1626 2892
.code 5722 2893
.code 3674 2894
.code 7770 2895
.code 346 2896
.code 4442 2897
.code 2394 2898
.code 6490 2899
.code 1370 2900
.code 5466 2901
.code 3418 2902
.code 7514 2903
.code 858 2904
.code 4954 2905
.code 2906 2906
.code 7002 2907
.code 1882 2908
.code 5978 2909
.code 3930 2910
.code 8026 2911
.code 218 2912
.code 4314 2913
.code 2266 2914
.code 6362 2915
.code 1242 2916
.code 5338 2917
.code 3290 2918
.code 7386 2919
.code 730 2920
.code 4826 2921
.code 2778 2922
.code 6874 2923
.code 1754 2924
.code 5850 2925
.code 3802 2926
.code 7898 2927
.code 474 2928
.code 4570 2929
.code 2522 2930
.code 6618 2931
.code 1498 2932
.code 5594 2933
.code 3546 2934
.code 7642 2935
.code 986 2936
.code 5082 2937
.code 3034 2938
.code 7130 2939
.code 2010 2940
.code 6106 2941
.code 4058 2942
.code 8154 2943
.code 58 2944
.code 4154 2945
.code 2106 2946
.code 6202 2947
.code 1082 2948
.code 5178 2949
.code 3130 2950
.code 7226 2951
.code 570 2952
.code 4666 2953
.code 2618 2954
.code 6714 2955
.code 1594 2956
.code 5690 2957
.code 3642 2958
.code 7738 2959
.code 314 2960
.code 4410 2961
.code 2362 2962
.code 6458 2963
.code 1338 2964
.code 5434 2965
.code 3386 2966
.code 7482 2967
.code 826 2968
.code 4922 2969
.code 2874 2970
.code 6970 2971
.code 1850 2972
.code 5946 2973
.code 3898 2974
.code 7994 2975
.code 186 2976
.code 4282 2977
.code 2234 2978
.code 6330 2979
.code 1210 2980
.code 5306 2981
.code 3258 2982
.code 7354 2983
.code 698 2984
.code 4794 2985
.code 2746 2986
.code 6842 2987
.code 1722 2988
.code 5818 2989
.code 3770 2990
.code 7866 2991
.code 442 2992
.code 4538 2993
.code 2490 2994
.code 6586 2995
.code 1466 2996
.code 5562 2997
.code 3514 2998
.code 7610 2999
.code 954 3000
.code 5050 3001
.code 3002 3002
.code 7098 3003
.code 1978 3004
.code 6074 3005
.code 4026 3006
.code 8122 3007
.code 122 3008
.code 4218 3009
.code 2170 3010
.code 6266 3011
.code 1146 3012
.code 5242 3013
.code 3194 3014
.code 7290 3015
.code 634 3016
.code 4730 3017
.code 2682 3018
.code 6778 3019
.code 1658 3020
.code 5754 3021
.code 3706 3022
.code 7802 3023
.code 378 3024
.code 4474 3025
.code 2426 3026
.code 6522 3027
.code 1402 3028
.code 5498 3029
.code 3450 3030
.code 7546 3031
.code 890 3032
.code 4986 3033
.code 2938 3034
.code 7034 3035
.code 1914 3036
.code 6010 3037
.code 3962 3038
.code 8058 3039
.code 250 3040
.code 4346 3041
.code 2298 3042
.code 6394 3043
.code 1274 3044
.code 5370 3045
.code 3322 3046
.code 7418 3047
.code 762 3048
.code 4858 3049
.code 2810 3050
.code 6906 3051
.code 1786 3052
.code 5882 3053
.code 3834 3054
.code 7930 3055
.code 506 3056
.code 4602 3057
.code 2554 3058
.code 6650 3059
.code 1530 3060
.code 5626 3061
.code 3578 3062
.code 7674 3063
.code 1018 3064
.code 5114 3065
.code 3066 3066
.code 7162 3067
.code 2042 3068
.code 6138 3069
.code 4090 3070
.code 8186 3071
.code 6 3072
.code 4102 3073
.code 2054 3074
.code 6150 3075
.code 1030 3076
.code 5126 3077
.code 3078 3078
.code 7174 3079
.code 518 3080
.code 4614 3081
.code 2566 3082
.code 6662 3083
.code 1542 3084
.code 5638 3085
.code 3590 3086
.code 7686 3087
.code 262 3088
.code 4358 3089
.code 2310 3090
.code 6406 3091
.code 1286 3092
.code 5382 3093
.code 3334 3094
.code 7430 3095
.code 774 3096
.code 4870 3097
.code 2822 3098
.code 6918 3099
.code 1798 3100
.code 5894 3101
.code 3846 3102
.code 7942 3103
.code 134 3104
.code 4230 3105
.code 2182 3106
.code 6278 3107
.code 1158 3108
.code 5254 3109
.code 3206 3110
.code 7302 3111
.code 646 3112
.code 4742 3113
.code 2694 3114
.code 6790 3115
.code 1670 3116
.code 5766 3117
.code 3718 3118
.code 7814 3119
.code 390 3120
.code 4486 3121
.code 2438 3122
.code 6534 3123
.code 1414 3124
.code 5510 3125
.code 3462 3126
.code 7558 3127
.code 902 3128
.code 4998 3129
.code 2950 3130
.code 7046 3131
.code 1926 3132
.code 6022 3133
.code 3974 3134
.code 8070 3135
.code 70 3136
.code 4166 3137
.code 2118 3138
.code 6214 3139
.code 1094 3140
.code 5190 3141
.code 3142 3142
.code 7238 3143
.code 582 3144
.code 4678 3145
.code 2630 3146
.code 6726 3147
.code 1606 3148
.code 5702 3149
.code 3654 3150
.code 7750 3151
.code 326 3152
.code 4422 3153
.code 2374 3154
.code 6470 3155
.code 1350 3156
.code 5446 3157
.code 3398 3158
.code 7494 3159
.code 838 3160
.code 4934 3161
.code 2886 3162
.code 6982 3163
.code 1862 3164
.code 5958 3165
.code 3910 3166
.code 8006 3167
.code 198 3168
.code 4294 3169
.code 2246 3170
.code 6342 3171
.code 1222 3172
.code 5318 3173
.code 3270 3174
.code 7366 3175
.code 710 3176
.code 4806 3177
.code 2758 3178
.code 6854 3179
.code 1734 3180
.code 5830 3181
.code 3782 3182
.code 7878 3183
.code 454 3184
.code 4550 3185
.code 2502 3186
.code 6598 3187
.code 1478 3188
.code 5574 3189
.code 3526 3190
.code 7622 3191
.code 966 3192
.code 5062 3193
.code 3014 3194
.code 7110 3195
.code 1990 3196
.code 6086 3197
.code 4038 3198
.code 8134 3199
.code 38 3200
.code 4134 3201
.code 2086 3202
.code 6182 3203
.code 1062 3204
.code 5158 3205
.code 3110 3206
.code 7206 3207
.code 550 3208
.code 4646 3209
.code 2598 3210
.code 6694 3211
.code 1574 3212
.code 5670 3213
.code 3622 3214
.code 7718 3215
.code 294 3216
.code 4390 3217
.code 2342 3218
.code 6438 3219
.code 1318 3220
.code 5414 3221
.code 3366 3222
.code 7462 3223
.code 806 3224
.code 4902 3225
.code 2854 3226
.code 6950 3227
.code 1830 3228
.code 5926 3229
.code 3878 3230
.code 7974 3231
.code 166 3232
.code 4262 3233
.code 2214 3234
.code 6310 3235
.code 1190 3236
.code 5286 3237
.code 3238 3238
.code 7334 3239
.code 678 3240
.code 4774 3241
.code 2726 3242
.code 6822 3243
.code 1702 3244
.code 5798 3245
.code 3750 3246
.code 7846 3247
.code 422 3248
.code 4518 3249
.code 2470 3250
.code 6566 3251
.code 1446 3252
.code 5542 3253
.code 3494 3254
.code 7590 3255
.code 934 3256
.code 5030 3257
.code 2982 3258
.code 7078 3259
.code 1958 3260
.code 6054 3261
.code 4006 3262
.code 8102 3263
.code 102 3264
.code 4198 3265
.code 2150 3266
.code 6246 3267
.code 1126 3268
.code 5222 3269
.code 3174 3270
.code 7270 3271
.code 614 3272
.code 4710 3273
.code 2662 3274
.code 6758 3275
.code 1638 3276
.code 5734 3277
.code 3686 3278
.code 7782 3279
.code 358 3280
.code 4454 3281
.code 2406 3282
.code 6502 3283
.code 1382 3284
.code 5478 3285
.code 3430 3286
.code 7526 3287
.code 870 3288
.code 4966 3289
.code 2918 3290
.code 7014 3291
.code 1894 3292
.code 5990 3293
.code 3942 3294
.code 8038 3295
.code 230 3296
.code 4326 3297
.code 2278 3298
.code 6374 3299
.code 1254 3300
.code 5350 3301
.code 3302 3302
.code 7398 3303
.code 742 3304
.code 4838 3305
.code 2790 3306
.code 6886 3307
.code 1766 3308
.code 5862 3309
.code 3814 3310
.code 7910 3311
.code 486 3312
.code 4582 3313
.code 2534 3314
.code 6630 3315
.code 1510 3316
.code 5606 3317
.code 3558 3318
.code 7654 3319
.code 998 3320
.code 5094 3321
.code 3046 3322
.code 7142 3323
.code 2022 3324
.code 6118 3325
.code 4070 3326
.code 8166 3327
.code 22 3328
.code 4118 3329
.code 2070 3330
.code 6166 3331
.code 1046 3332
.code 5142 3333
.code 3094 3334
.code 7190 3335
.code 534 3336
.code 4630 3337
.code 2582 3338
.code 6678 3339
.code 1558 3340
.code 5654 3341
.code 3606 3342
.code 7702 3343
.code 278 3344
.code 4374 3345
.code 2326 3346
.code 6422 3347
.code 1302 3348
.code 5398 3349
.code 3350 3350
.code 7446 3351
.code 790 3352
.code 4886 3353
.code 2838 3354
.code 6934 3355
.code 1814 3356
.code 5910 3357
.code 3862 3358
.code 7958 3359
.code 150 3360
.code 4246 3361
.code 2198 3362
.code 6294 3363
.code 1174 3364
.code 5270 3365
.code 3222 3366
.code 7318 3367
.code 662 3368
.code 4758 3369
.code 2710 3370
.code 6806 3371
.code 1686 3372
.code 5782 3373
.code 3734 3374
.code 7830 3375
.code 406 3376
.code 4502 3377
.code 2454 3378
.code 6550 3379
.code 1430 3380
.code 5526 3381
.code 3478 3382
.code 7574 3383
.code 918 3384
.code 5014 3385
.code 2966 3386
.code 7062 3387
.code 1942 3388
.code 6038 3389
.code 3990 3390
.code 8086 3391
.code 86 3392
.code 4182 3393
.code 2134 3394
.code 6230 3395
.code 1110 3396
.code 5206 3397
.code 3158 3398
.code 7254 3399
.code 598 3400
.code 4694 3401
.code 2646 3402
.code 6742 3403
.code 1622 3404
.code 5718 3405
.code 3670 3406
.code 7766 3407
.code 342 3408
.code 4438 3409
.code 2390 3410
.code 6486 3411
.code 1366 3412
.code 5462 3413
.code 3414 3414
.code 7510 3415
.code 854 3416
.code 4950 3417
.code 2902 3418
.code 6998 3419
.code 1878 3420
.code 5974 3421
.code 3926 3422
.code 8022 3423
.code 214 3424
.code 4310 3425
.code 2262 3426
.code 6358 3427
.code 1238 3428
.code 5334 3429
.code 3286 3430
.code 7382 3431
.code 726 3432
.code 4822 3433
.code 2774 3434
.code 6870 3435
.code 1750 3436
.code 5846 3437
.code 3798 3438
.code 7894 3439
.code 470 3440
.code 4566 3441
.code 2518 3442
.code 6614 3443
.code 1494 3444
.code 5590 3445
.code 3542 3446
.code 7638 3447
.code 982 3448
.code 5078 3449
.code 3030 3450
.code 7126 3451
.code 2006 3452
.code 6102 3453
.code 4054 3454
.code 8150 3455
.code 54 3456
.code 4150 3457
.code 2102 3458
.code 6198 3459
.code 1078 3460
.code 5174 3461
.code 3126 3462
.code 7222 3463
.code 566 3464
.code 4662 3465
.code 2614 3466
.code 6710 3467
.code 1590 3468
.code 5686 3469
.code 3638 3470
.code 7734 3471
.code 310 3472
.code 4406 3473
.code 2358 3474
.code 6454 3475
.code 1334 3476
.code 5430 3477
.code 3382 3478
.code 7478 3479
.code 822 3480
.code 4918 3481
.code 2870 3482
.code 6966 3483
.code 1846 3484
.code 5942 3485
.code 3894 3486
.code 7990 3487
.code 182 3488
.code 4278 3489
.code 2230 3490
.code 6326 3491
.code 1206 3492
.code 5302 3493
.code 3254 3494
.code 7350 3495
.code 694 3496
.code 4790 3497
.code 2742 3498
.code 6838 3499
.code 1718 3500
.code 5814 3501
.code 3766 3502
.code 7862 3503
.code 438 3504
.code 4534 3505
.code 2486 3506
.code 6582 3507
.code 1462 3508
.code 5558 3509
.code 3510 3510
.code 7606 3511
.code 950 3512
.code 5046 3513
.code 2998 3514
.code 7094 3515
.code 1974 3516
.code 6070 3517
.code 4022 3518
.code 8118 3519
.code 118 3520
.code 4214 3521
.code 2166 3522
.code 6262 3523
.code 1142 3524
.code 5238 3525
.code 3190 3526
.code 7286 3527
.code 630 3528
.code 4726 3529
.code 2678 3530
.code 6774 3531
.code 1654 3532
.code 5750 3533
.code 3702 3534
.code 7798 3535
.code 374 3536
.code 4470 3537
.code 2422 3538
.code 6518 3539
.code 1398 3540
.code 5494 3541
.code 3446 3542
.code 7542 3543
.code 886 3544
.code 4982 3545
.code 2934 3546
.code 7030 3547
.code 1910 3548
.code 6006 3549
.code 3958 3550
.code 8054 3551
.code 246 3552
.code 4342 3553
.code 2294 3554
.code 6390 3555
.code 1270 3556
.code 5366 3557
.code 3318 3558
.code 7414 3559
.code 758 3560
.code 4854 3561
.code 2806 3562
.code 6902 3563
.code 1782 3564
.code 5878 3565
.code 3830 3566
.code 7926 3567
.code 502 3568
.code 4598 3569
.code 2550 3570
.code 6646 3571
.code 1526 3572
.code 5622 3573
.code 3574 3574
.code 7670 3575
.code 1014 3576
.code 5110 3577
.code 3062 3578
.code 7158 3579
.code 2038 3580
.code 6134 3581
.code 4086 3582
.code 8182 3583
.code 14 3584
.code 4110 3585
.code 2062 3586
.code 6158 3587
.code 1038 3588
.code 5134 3589
.code 3086 3590
.code 7182 3591
.code 526 3592
.code 4622 3593
.code 2574 3594
.code 6670 3595
.code 1550 3596
.code 5646 3597
.code 3598 3598
.code 7694 3599
.code 270 3600
.code 4366 3601
.code 2318 3602
.code 6414 3603
.code 1294 3604
.code 5390 3605
.code 3342 3606
.code 7438 3607
.code 782 3608
.code 4878 3609
.code 2830 3610
.code 6926 3611
.code 1806 3612
.code 5902 3613
.code 3854 3614
.code 7950 3615
.code 142 3616
.code 4238 3617
.code 2190 3618
.code 6286 3619
.code 1166 3620
.code 5262 3621
.code 3214 3622
.code 7310 3623
.code 654 3624
.code 4750 3625
.code 2702 3626
.code 6798 3627
.code 1678 3628
.code 5774 3629
.code 3726 3630
.code 7822 3631
.code 398 3632
.code 4494 3633
.code 2446 3634
.code 6542 3635
.code 1422 3636
.code 5518 3637
.code 3470 3638
.code 7566 3639
.code 910 3640
.code 5006 3641
.code 2958 3642
.code 7054 3643
.code 1934 3644
.code 6030 3645
.code 3982 3646
.code 8078 3647
.code 78 3648
.code 4174 3649
.code 2126 3650
.code 6222 3651
.code 1102 3652
.code 5198 3653
.code 3150 3654
.code 7246 3655
.code 590 3656
.code 4686 3657
.code 2638 3658
.code 6734 3659
.code 1614 3660
.code 5710 3661
.code 3662 3662
.code 7758 3663
.code 334 3664
.code 4430 3665
.code 2382 3666
.code 6478 3667
.code 1358 3668
.code 5454 3669
.code 3406 3670
.code 7502 3671
.code 846 3672
.code 4942 3673
.code 2894 3674
.code 6990 3675
.code 1870 3676
.code 5966 3677
.code 3918 3678
.code 8014 3679
.code 206 3680
.code 4302 3681
.code 2254 3682
.code 6350 3683
.code 1230 3684
.code 5326 3685
.code 3278 3686
.code 7374 3687
.code 718 3688
.code 4814 3689
.code 2766 3690
.code 6862 3691
.code 1742 3692
.code 5838 3693
.code 3790 3694
.code 7886 3695
.code 462 3696
.code 4558 3697
.code 2510 3698
.code 6606 3699
.code 1486 3700
.code 5582 3701
.code 3534 3702
.code 7630 3703
.code 974 3704
.code 5070 3705
.code 3022 3706
.code 7118 3707
.code 1998 3708
.code 6094 3709
.code 4046 3710
.code 8142 3711
.code 46 3712
.code 4142 3713
.code 2094 3714
.code 6190 3715
.code 1070 3716
.code 5166 3717
.code 3118 3718
.code 7214 3719
.code 558 3720
.code 4654 3721
.code 2606 3722
.code 6702 3723
.code 1582 3724
.code 5678 3725
.code 3630 3726
.code 7726 3727
.code 302 3728
.code 4398 3729
.code 2350 3730
.code 6446 3731
.code 1326 3732
.code 5422 3733
.code 3374 3734
.code 7470 3735
.code 814 3736
.code 4910 3737
.code 2862 3738
.code 6958 3739
.code 1838 3740
.code 5934 3741
.code 3886 3742
.code 7982 3743
.code 174 3744
.code 4270 3745
.code 2222 3746
.code 6318 3747
.code 1198 3748
.code 5294 3749
.code 3246 3750
.code 7342 3751
.code 686 3752
.code 4782 3753
.code 2734 3754
.code 6830 3755
.code 1710 3756
.code 5806 3757
.code 3758 3758
.code 7854 3759
.code 430 3760
.code 4526 3761
.code 2478 3762
.code 6574 3763
.code 1454 3764
.code 5550 3765
.code 3502 3766
.code 7598 3767
.code 942 3768
.code 5038 3769
.code 2990 3770
.code 7086 3771
.code 1966 3772
.code 6062 3773
.code 4014 3774
.code 8110 3775
.code 110 3776
.code 4206 3777
.code 2158 3778
.code 6254 3779
.code 1134 3780
.code 5230 3781
.code 3182 3782
.code 7278 3783
.code 622 3784
.code 4718 3785
.code 2670 3786
.code 6766 3787
.code 1646 3788
.code 5742 3789
.code 3694 3790
.code 7790 3791
.code 366 3792
.code 4462 3793
.code 2414 3794
.code 6510 3795
.code 1390 3796
.code 5486 3797
.code 3438 3798
.code 7534 3799
.code 878 3800
.code 4974 3801
.code 2926 3802
.code 7022 3803
.code 1902 3804
.code 5998 3805
.code 3950 3806
.code 8046 3807
.code 238 3808
.code 4334 3809
.code 2286 3810
.code 6382 3811
.code 1262 3812
.code 5358 3813
.code 3310 3814
.code 7406 3815
.code 750 3816
.code 4846 3817
.code 2798 3818
.code 6894 3819
.code 1774 3820
.code 5870 3821
.code 3822 3822
.code 7918 3823
.code 494 3824
.code 4590 3825
.code 2542 3826
.code 6638 3827
.code 1518 3828
.code 5614 3829
.code 3566 3830
.code 7662 3831
.code 1006 3832
.code 5102 3833
.code 3054 3834
.code 7150 3835
.code 2030 3836
.code 6126 3837
.code 4078 3838
.code 8174 3839
.code 30 3840
.code 4126 3841
.code 2078 3842
.code 6174 3843
.code 1054 3844
.code 5150 3845
.code 3102 3846
.code 7198 3847
.code 542 3848
.code 4638 3849
.code 2590 3850
.code 6686 3851
.code 1566 3852
.code 5662 3853
.code 3614 3854
.code 7710 3855
.code 286 3856
.code 4382 3857
.code 2334 3858
.code 6430 3859
.code 1310 3860
.code 5406 3861
.code 3358 3862
.code 7454 3863
.code 798 3864
.code 4894 3865
.code 2846 3866
.code 6942 3867
.code 1822 3868
.code 5918 3869
.code 3870 3870
.code 7966 3871
.code 158 3872
.code 4254 3873
.code 2206 3874
.code 6302 3875
.code 1182 3876
.code 5278 3877
.code 3230 3878
.code 7326 3879
.code 670 3880
.code 4766 3881
.code 2718 3882
.code 6814 3883
.code 1694 3884
.code 5790 3885
.code 3742 3886
.code 7838 3887
.code 414 3888
.code 4510 3889
.code 2462 3890
.code 6558 3891
.code 1438 3892
.code 5534 3893
.code 3486 3894
.code 7582 3895
.code 926 3896
.code 5022 3897
.code 2974 3898
.code 7070 3899
.code 1950 3900
.code 6046 3901
.code 3998 3902
.code 8094 3903
.code 94 3904
.code 4190 3905
.code 2142 3906
.code 6238 3907
.code 1118 3908
.code 5214 3909
.code 3166 3910
.code 7262 3911
.code 606 3912
.code 4702 3913
.code 2654 3914
.code 6750 3915
.code 1630 3916
.code 5726 3917
.code 3678 3918
.code 7774 3919
.code 350 3920
.code 4446 3921
.code 2398 3922
.code 6494 3923
.code 1374 3924
.code 5470 3925
.code 3422 3926
.code 7518 3927
.code 862 3928
.code 4958 3929
.code 2910 3930
.code 7006 3931
.code 1886 3932
.code 5982 3933
.code 3934 3934
.code 8030 3935
.code 222 3936
.code 4318 3937
.code 2270 3938
.code 6366 3939
.code 1246 3940
.code 5342 3941
.code 3294 3942
.code 7390 3943
.code 734 3944
.code 4830 3945
.code 2782 3946
.code 6878 3947
.code 1758 3948
.code 5854 3949
.code 3806 3950
.code 7902 3951
.code 478 3952
.code 4574 3953
.code 2526 3954
.code 6622 3955
.code 1502 3956
.code 5598 3957
.code 3550 3958
.code 7646 3959
.code 990 3960
.code 5086 3961
.code 3038 3962
.code 7134 3963
.code 2014 3964
.code 6110 3965
.code 4062 3966
.code 8158 3967
.code 62 3968
.code 4158 3969
.code 2110 3970
.code 6206 3971
.code 1086 3972
.code 5182 3973
.code 3134 3974
.code 7230 3975
.code 574 3976
.code 4670 3977
.code 2622 3978
.code 6718 3979
.code 1598 3980
.code 5694 3981
.code 3646 3982
.code 7742 3983
.code 318 3984
.code 4414 3985
.code 2366 3986
.code 6462 3987
.code 1342 3988
.code 5438 3989
.code 3390 3990
.code 7486 3991
.code 830 3992
.code 4926 3993
.code 2878 3994
.code 6974 3995
.code 1854 3996
.code 5950 3997
.code 3902 3998
.code 7998 3999
.code 190 4000
.code 4286 4001
.code 2238 4002
.code 6334 4003
.code 1214 4004
.code 5310 4005
.code 3262 4006
.code 7358 4007
.code 702 4008
.code 4798 4009
.code 2750 4010
.code 6846 4011
.code 1726 4012
.code 5822 4013
.code 3774 4014
.code 7870 4015
.code 446 4016
.code 4542 4017
.code 2494 4018
.code 6590 4019
.code 1470 4020
.code 5566 4021
.code 3518 4022
.code 7614 4023
.code 958 4024
.code 5054 4025
.code 3006 4026
.code 7102 4027
.code 1982 4028
.code 6078 4029
.code 4030 4030
.code 8126 4031
.code 126 4032
.code 4222 4033
.code 2174 4034
.code 6270 4035
.code 1150 4036
.code 5246 4037
.code 3198 4038
.code 7294 4039
.code 638 4040
.code 4734 4041
.code 2686 4042
.code 6782 4043
.code 1662 4044
.code 5758 4045
.code 3710 4046
.code 7806 4047
.code 382 4048
.code 4478 4049
.code 2430 4050
.code 6526 4051
.code 1406 4052
.code 5502 4053
.code 3454 4054
.code 7550 4055
.code 894 4056
.code 4990 4057
.code 2942 4058
.code 7038 4059
.code 1918 4060
.code 6014 4061
.code 3966 4062
.code 8062 4063
.code 254 4064
.code 4350 4065
.code 2302 4066
.code 6398 4067
.code 1278 4068
.code 5374 4069
.code 3326 4070
.code 7422 4071
.code 766 4072
.code 4862 4073
.code 2814 4074
.code 6910 4075
.code 1790 4076
.code 5886 4077
.code 3838 4078
.code 7934 4079
.code 510 4080
.code 4606 4081
.code 2558 4082
.code 6654 4083
.code 1534 4084
.code 5630 4085
.code 3582 4086
.code 7678 4087
.code 1022 4088
.code 5118 4089
.code 3070 4090
.code 7166 4091
.code 2046 4092
.code 6142 4093
.code 4094 4094
.code 8190 4095
.code 1 4096
.code 4097 4097
.code 2049 4098
.code 6145 4099
.code 1025 4100
.code 5121 4101
.code 3073 4102
.code 7169 4103
.code 513 4104
.code 4609 4105
.code 2561 4106
.code 6657 4107
.code 1537 4108
.code 5633 4109
.code 3585 4110
.code 7681 4111
.code 257 4112
.code 4353 4113
.code 2305 4114
.code 6401 4115
.code 1281 4116
.code 5377 4117
.code 3329 4118
.code 7425 4119
.code 769 4120
.code 4865 4121
.code 2817 4122
.code 6913 4123
.code 1793 4124
.code 5889 4125
.code 3841 4126
.code 7937 4127
.code 129 4128
.code 4225 4129
.code 2177 4130
.code 6273 4131
.code 1153 4132
.code 5249 4133
.code 3201 4134
.code 7297 4135
.code 641 4136
.code 4737 4137
.code 2689 4138
.code 6785 4139
.code 1665 4140
.code 5761 4141
.code 3713 4142
.code 7809 4143
.code 385 4144
.code 4481 4145
.code 2433 4146
.code 6529 4147
.code 1409 4148
.code 5505 4149
.code 3457 4150
.code 7553 4151
.code 897 4152
.code 4993 4153
.code 2945 4154
.code 7041 4155
.code 1921 4156
.code 6017 4157
.code 3969 4158
.code 8065 4159
.code 65 4160
.code 4161 4161
.code 2113 4162
.code 6209 4163
.code 1089 4164
.code 5185 4165
.code 3137 4166
.code 7233 4167
.code 577 4168
.code 4673 4169
.code 2625 4170
.code 6721 4171
.code 1601 4172
.code 5697 4173
.code 3649 4174
.code 7745 4175
.code 321 4176
.code 4417 4177
.code 2369 4178
.code 6465 4179
.code 1345 4180
.code 5441 4181
.code 3393 4182
.code 7489 4183
.code 833 4184
.code 4929 4185
.code 2881 4186
.code 6977 4187
.code 1857 4188
.code 5953 4189
.code 3905 4190
.code 8001 4191
.code 193 4192
.code 4289 4193
.code 2241 4194
.code 6337 4195
.code 1217 4196
.code 5313 4197
.code 3265 4198
.code 7361 4199
.code 705 4200
.code 4801 4201
.code 2753 4202
.code 6849 4203
.code 1729 4204
.code 5825 4205
.code 3777 4206
.code 7873 4207
.code 449 4208
.code 4545 4209
.code 2497 4210
.code 6593 4211
.code 1473 4212
.code 5569 4213
.code 3521 4214
.code 7617 4215
.code 961 4216
.code 5057 4217
.code 3009 4218
.code 7105 4219
.code 1985 4220
.code 6081 4221
.code 4033 4222
.code 8129 4223
.code 33 4224
.code 4129 4225
.code 2081 4226
.code 6177 4227
.code 1057 4228
.code 5153 4229
.code 3105 4230
.code 7201 4231
.code 545 4232
.code 4641 4233
.code 2593 4234
.code 6689 4235
.code 1569 4236
.code 5665 4237
.code 3617 4238
.code 7713 4239
.code 289 4240
.code 4385 4241
.code 2337 4242
.code 6433 4243
.code 1313 4244
.code 5409 4245
.code 3361 4246
.code 7457 4247
.code 801 4248
.code 4897 4249
.code 2849 4250
.code 6945 4251
.code 1825 4252
.code 5921 4253
.code 3873 4254
.code 7969 4255
.code 161 4256
.code 4257 4257
.code 2209 4258
.code 6305 4259
.code 1185 4260
.code 5281 4261
.code 3233 4262
.code 7329 4263
.code 673 4264
.code 4769 4265
.code 2721 4266
.code 6817 4267
.code 1697 4268
.code 5793 4269
.code 3745 4270
.code 7841 4271
.code 417 4272
.code 4513 4273
.code 2465 4274
.code 6561 4275
.code 1441 4276
.code 5537 4277
.code 3489 4278
.code 7585 4279
.code 929 4280
.code 5025 4281
.code 2977 4282
.code 7073 4283
.code 1953 4284
.code 6049 4285
.code 4001 4286
.code 8097 4287
.code 97 4288
.code 4193 4289
.code 2145 4290
.code 6241 4291
.code 1121 4292
.code 5217 4293
.code 3169 4294
.code 7265 4295
.code 609 4296
.code 4705 4297
.code 2657 4298
.code 6753 4299
.code 1633 4300
.code 5729 4301
.code 3681 4302
.code 7777 4303
.code 353 4304
.code 4449 4305
.code 2401 4306
.code 6497 4307
.code 1377 4308
.code 5473 4309
.code 3425 4310
.code 7521 4311
.code 865 4312
.code 4961 4313
.code 2913 4314
.code 7009 4315
.code 1889 4316
.code 5985 4317
.code 3937 4318
.code 8033 4319
.code 225 4320
.code 4321 4321
.code 2273 4322
.code 6369 4323
.code 1249 4324
.code 5345 4325
.code 3297 4326
.code 7393 4327
.code 737 4328
.code 4833 4329
.code 2785 4330
.code 6881 4331
.code 1761 4332
.code 5857 4333
.code 3809 4334
.code 7905 4335
.code 481 4336
.code 4577 4337
.code 2529 4338
.code 6625 4339
.code 1505 4340
.code 5601 4341
.code 3553 4342
.code 7649 4343
.code 993 4344
.code 5089 4345
.code 3041 4346
.code 7137 4347
.code 2017 4348
.code 6113 4349
.code 4065 4350
.code 8161 4351
.code 17 4352
.code 4113 4353
.code 2065 4354
.code 6161 4355
.code 1041 4356
.code 5137 4357
.code 3089 4358
.code 7185 4359
.code 529 4360
.code 4625 4361
.code 2577 4362
.code 6673 4363
.code 1553 4364
.code 5649 4365
.code 3601 4366
.code 7697 4367
.code 273 4368
.code 4369 4369
.code 2321 4370
.code 6417 4371
.code 1297 4372
.code 5393 4373
.code 3345 4374
.code 7441 4375
.code 785 4376
.code 4881 4377
.code 2833 4378
.code 6929 4379
.code 1809 4380
.code 5905 4381
.code 3857 4382
.code 7953 4383
.code 145 4384
.code 4241 4385
.code 2193 4386
.code 6289 4387
.code 1169 4388
.code 5265 4389
.code 3217 4390
.code 7313 4391
.code 657 4392
.code 4753 4393
.code 2705 4394
.code 6801 4395
.code 1681 4396
.code 5777 4397
.code 3729 4398
.code 7825 4399
.code 401 4400
.code 4497 4401
.code 2449 4402
.code 6545 4403
.code 1425 4404
.code 5521 4405
.code 3473 4406
.code 7569 4407
.code 913 4408
.code 5009 4409
.code 2961 4410
.code 7057 4411
.code 1937 4412
.code 6033 4413
.code 3985 4414
.code 8081 4415
.code 81 4416
.code 4177 4417
.code 2129 4418
.code 6225 4419
.code 1105 4420
.code 5201 4421
.code 3153 4422
.code 7249 4423
.code 593 4424
.code 4689 4425
.code 2641 4426
.code 6737 4427
.code 1617 4428
.code 5713 4429
.code 3665 4430
.code 7761 4431
.code 337 4432
.code 4433 4433
.code 2385 4434
.code 6481 4435
.code 1361 4436
.code 5457 4437
.code 3409 4438
.code 7505 4439
.code 849 4440
.code 4945 4441
.code 2897 4442
.code 6993 4443
.code 1873 4444
.code 5969 4445
.code 3921 4446
.code 8017 4447
.code 209 4448
.code 4305 4449
.code 2257 4450
.code 6353 4451
.code 1233 4452
.code 5329 4453
.code 3281 4454
.code 7377 4455
.code 721 4456
.code 4817 4457
.code 2769 4458
.code 6865 4459
.code 1745 4460
.code 5841 4461
.code 3793 4462
.code 7889 4463
.code 465 4464
.code 4561 4465
.code 2513 4466
.code 6609 4467
.code 1489 4468
.code 5585 4469
.code 3537 4470
.code 7633 4471
.code 977 4472
.code 5073 4473
.code 3025 4474
.code 7121 4475
.code 2001 4476
.code 6097 4477
.code 4049 4478
.code 8145 4479
.code 49 4480
.code 4145 4481
.code 2097 4482
.code 6193 4483
.code 1073 4484
.code 5169 4485
.code 3121 4486
.code 7217 4487
.code 561 4488
.code 4657 4489
.code 2609 4490
.code 6705 4491
.code 1585 4492
.code 5681 4493
.code 3633 4494
.code 7729 4495
.code 305 4496
.code 4401 4497
.code 2353 4498
.code 6449 4499
.code 1329 4500
.code 5425 4501
.code 3377 4502
.code 7473 4503
.code 817 4504
.code 4913 4505
.code 2865 4506
.code 6961 4507
.code 1841 4508
.code 5937 4509
.code 3889 4510
.code 7985 4511
.code 177 4512
.code 4273 4513
.code 2225 4514
.code 6321 4515
.code 1201 4516
.code 5297 4517
.code 3249 4518
.code 7345 4519
.code 689 4520
.code 4785 4521
.code 2737 4522
.code 6833 4523
.code 1713 4524
.code 5809 4525
.code 3761 4526
.code 7857 4527
.code 433 4528
.code 4529 4529
.code 2481 4530
.code 6577 4531
.code 1457 4532
.code 5553 4533
.code 3505 4534
.code 7601 4535
.code 945 4536
.code 5041 4537
.code 2993 4538
.code 7089 4539
.code 1969 4540
.code 6065 4541
.code 4017 4542
.code 8113 4543
.code 113 4544
.code 4209 4545
.code 2161 4546
.code 6257 4547
.code 1137 4548
.code 5233 4549
.code 3185 4550
.code 7281 4551
.code 625 4552
.code 4721 4553
.code 2673 4554
.code 6769 4555
.code 1649 4556
.code 5745 4557
.code 3697 4558
.code 7793 4559
.code 369 4560
.code 4465 4561
.code 2417 4562
.code 6513 4563
.code 1393 4564
.code 5489 4565
.code 3441 4566
.code 7537 4567
.code 881 4568
.code 4977 4569
.code 2929 4570
.code 7025 4571
.code 1905 4572
.code 6001 4573
.code 3953 4574
.code 8049 4575
.code 241 4576
.code 4337 4577
.code 2289 4578
.code 6385 4579
.code 1265 4580
.code 5361 4581
.code 3313 4582
.code 7409 4583
.code 753 4584
.code 4849 4585
.code 2801 4586
.code 6897 4587
.code 1777 4588
.code 5873 4589
.code 3825 4590
.code 7921 4591
.code 497 4592
.code 4593 4593
.code 2545 4594
.code 6641 4595
.code 1521 4596
.code 5617 4597
.code 3569 4598
.code 7665 4599
.code 1009 4600
.code 5105 4601
.code 3057 4602
.code 7153 4603
.code 2033 4604
.code 6129 4605
.code 4081 4606
.code 8177 4607
.code 9 4608
.code 4105 4609
.code 2057 4610
.code 6153 4611
.code 1033 4612
.code 5129 4613
.code 3081 4614
.code 7177 4615
.code 521 4616
.code 4617 4617
.code 2569 4618
.code 6665 4619
.code 1545 4620
.code 5641 4621
.code 3593 4622
.code 7689 4623
.code 265 4624
.code 4361 4625
.code 2313 4626
.code 6409 4627
.code 1289 4628
.code 5385 4629
.code 3337 4630
.code 7433 4631
.code 777 4632
.code 4873 4633
.code 2825 4634
.code 6921 4635
.code 1801 4636
.code 5897 4637
.code 3849 4638
.code 7945 4639
.code 137 4640
.code 4233 4641
.code 2185 4642
.code 6281 4643
.code 1161 4644
.code 5257 4645
.code 3209 4646
.code 7305 4647
.code 649 4648
.code 4745 4649
.code 2697 4650
.code 6793 4651
.code 1673 4652
.code 5769 4653
.code 3721 4654
.code 7817 4655
.code 393 4656
.code 4489 4657
.code 2441 4658
.code 6537 4659
.code 1417 4660
.code 5513 4661
.code 3465 4662
.code 7561 4663
.code 905 4664
.code 5001 4665
.code 2953 4666
.code 7049 4667
.code 1929 4668
.code 6025 4669
.code 3977 4670
.code 8073 4671
.code 73 4672
.code 4169 4673
.code 2121 4674
.code 6217 4675
.code 1097 4676
.code 5193 4677
.code 3145 4678
.code 7241 4679
.code 585 4680
.code 4681 4681
.code 2633 4682
.code 6729 4683
.code 1609 4684
.code 5705 4685
.code 3657 4686
.code 7753 4687
.code 329 4688
.code 4425 4689
.code 2377 4690
.code 6473 4691
.code 1353 4692
.code 5449 4693
.code 3401 4694
.code 7497 4695
.code 841 4696
.code 4937 4697
.code 2889 4698
.code 6985 4699
.code 1865 4700
.code 5961 4701
.code 3913 4702
.code 8009 4703
.code 201 4704
.code 4297 4705
.code 2249 4706
.code 6345 4707
.code 1225 4708
.code 5321 4709
.code 3273 4710
.code 7369 4711
.code 713 4712
.code 4809 4713
.code 2761 4714
.code 6857 4715
.code 1737 4716
.code 5833 4717
.code 3785 4718
.code 7881 4719
.code 457 4720
.code 4553 4721
.code 2505 4722
.code 6601 4723
.code 1481 4724
.code 5577 4725
.code 3529 4726
.code 7625 4727
.code 969 4728
.code 5065 4729
.code 3017 4730
.code 7113 4731
.code 1993 4732
.code 6089 4733
.code 4041 4734
.code 8137 4735
.code 41 4736
.code 4137 4737
.code 2089 4738
.code 6185 4739
.code 1065 4740
.code 5161 4741
.code 3113 4742
.code 7209 4743
.code 553 4744
.code 4649 4745
.code 2601 4746
.code 6697 4747
.code 1577 4748
.code 5673 4749
.code 3625 4750
.code 7721 4751
.code 297 4752
.code 4393 4753
.code 2345 4754
.code 6441 4755
.code 1321 4756
.code 5417 4757
.code 3369 4758
.code 7465 4759
.code 809 4760
.code 4905 4761
.code 2857 4762
.code 6953 4763
.code 1833 4764
.code 5929 4765
.code 3881 4766
.code 7977 4767
.code 169 4768
.code 4265 4769
.code 2217 4770
.code 6313 4771
.code 1193 4772
.code 5289 4773
.code 3241 4774
.code 7337 4775
.code 681 4776
.code 4777 4777
.code 2729 4778
.code 6825 4779
.code 1705 4780
.code 5801 4781
.code 3753 4782
.code 7849 4783
.code 425 4784
.code 4521 4785
.code 2473 4786
.code 6569 4787
.code 1449 4788
.code 5545 4789
.code 3497 4790
.code 7593 4791
.code 937 4792
.code 5033 4793
.code 2985 4794
.code 7081 4795
.code 1961 4796
.code 6057 4797
.code 4009 4798
.code 8105 4799
.code 105 4800
.code 4201 4801
.code 2153 4802
.code 6249 4803
.code 1129 4804
.code 5225 4805
.code 3177 4806
.code 7273 4807
.code 617 4808
.code 4713 4809
.code 2665 4810
.code 6761 4811
.code 1641 4812
.code 5737 4813
.code 3689 4814
.code 7785 4815
.code 361 4816
.code 4457 4817
.code 2409 4818
.code 6505 4819
.code 1385 4820
.code 5481 4821
.code 3433 4822
.code 7529 4823
.code 873 4824
.code 4969 4825
.code 2921 4826
.code 7017 4827
.code 1897 4828
.code 5993 4829
.code 3945 4830
.code 8041 4831
.code 233 4832
.code 4329 4833
.code 2281 4834
.code 6377 4835
.code 1257 4836
.code 5353 4837
.code 3305 4838
.code 7401 4839
.code 745 4840
.code 4841 4841
.code 2793 4842
.code 6889 4843
.code 1769 4844
.code 5865 4845
.code 3817 4846
.code 7913 4847
.code 489 4848
.code 4585 4849
.code 2537 4850
.code 6633 4851
.code 1513 4852
.code 5609 4853
.code 3561 4854
.code 7657 4855
.code 1001 4856
.code 5097 4857
.code 3049 4858
.code 7145 4859
.code 2025 4860
.code 6121 4861
.code 4073 4862
.code 8169 4863
.code 25 4864
.code 4121 4865
.code 2073 4866
.code 6169 4867
.code 1049 4868
.code 5145 4869
.code 3097 4870
.code 7193 4871
.code 537 4872
.code 4633 4873
.code 2585 4874
.code 6681 4875
.code 1561 4876
.code 5657 4877
.code 3609 4878
.code 7705 4879
.code 281 4880
.code 4377 4881
.code 2329 4882
.code 6425 4883
.code 1305 4884
.code 5401 4885
.code 3353 4886
.code 7449 4887
.code 793 4888
.code 4889 4889
.code 2841 4890
.code 6937 4891
.code 1817 4892
.code 5913 4893
.code 3865 4894
.code 7961 4895
.code 153 4896
.code 4249 4897
.code 2201 4898
.code 6297 4899
.code 1177 4900
.code 5273 4901
.code 3225 4902
.code 7321 4903
.code 665 4904
.code 4761 4905
.code 2713 4906
.code 6809 4907
.code 1689 4908
.code 5785 4909
.code 3737 4910
.code 7833 4911
.code 409 4912
.code 4505 4913
.code 2457 4914
.code 6553 4915
.code 1433 4916
.code 5529 4917
.code 3481 4918
.code 7577 4919
.code 921 4920
.code 5017 4921
.code 2969 4922
.code 7065 4923
.code 1945 4924
.code 6041 4925
.code 3993 4926
.code 8089 4927
.code 89 4928
.code 4185 4929
.code 2137 4930
.code 6233 4931
.code 1113 4932
.code 5209 4933
.code 3161 4934
.code 7257 4935
.code 601 4936
.code 4697 4937
.code 2649 4938
.code 6745 4939
.code 1625 4940
.code 5721 4941
.code 3673 4942
.code 7769 4943
.code 345 4944
.code 4441 4945
.code 2393 4946
.code 6489 4947
.code 1369 4948
.code 5465 4949
.code 3417 4950
.code 7513 4951
.code 857 4952
.code 4953 4953
.code 2905 4954
.code 7001 4955
.code 1881 4956
.code 5977 4957
.code 3929 4958
.code 8025 4959
.code 217 4960
.code 4313 4961
.code 2265 4962
.code 6361 4963
.code 1241 4964
.code 5337 4965
.code 3289 4966
.code 7385 4967
.code 729 4968
.code 4825 4969
.code 2777 4970
.code 6873 4971
.code 1753 4972
.code 5849 4973
.code 3801 4974
.code 7897 4975
.code 473 4976
.code 4569 4977
.code 2521 4978
.code 6617 4979
.code 1497 4980
.code 5593 4981
.code 3545 4982
.code 7641 4983
.code 985 4984
.code 5081 4985
.code 3033 4986
.code 7129 4987
.code 2009 4988
.code 6105 4989
.code 4057 4990
.code 8153 4991
.code 57 4992
.code 4153 4993
.code 2105 4994
.code 6201 4995
.code 1081 4996
.code 5177 4997
.code 3129 4998
.code 7225 4999
.code 569 5000
.code 4665 5001
.code 2617 5002
.code 6713 5003
.code 1593 5004
.code 5689 5005
.code 3641 5006
.code 7737 5007
.code 313 5008
.code 4409 5009
.code 2361 5010
.code 6457 5011
.code 1337 5012
.code 5433 5013
.code 3385 5014
.code 7481 5015
.code 825 5016
.code 4921 5017
.code 2873 5018
.code 6969 5019
.code 1849 5020
.code 5945 5021
.code 3897 5022
.code 7993 5023
.code 185 5024
.code 4281 5025
.code 2233 5026
.code 6329 5027
.code 1209 5028
.code 5305 5029
.code 3257 5030
.code 7353 5031
.code 697 5032
.code 4793 5033
.code 2745 5034
.code 6841 5035
.code 1721 5036
.code 5817 5037
.code 3769 5038
.code 7865 5039
.code 441 5040
.code 4537 5041
.code 2489 5042
.code 6585 5043
.code 1465 5044
.code 5561 5045
.code 3513 5046
.code 7609 5047
.code 953 5048
.code 5049 5049
.code 3001 5050
.code 7097 5051
.code 1977 5052
.code 6073 5053
.code 4025 5054
.code 8121 5055
.code 121 5056
.code 4217 5057
.code 2169 5058
.code 6265 5059
.code 1145 5060
.code 5241 5061
.code 3193 5062
.code 7289 5063
.code 633 5064
.code 4729 5065
.code 2681 5066
.code 6777 5067
.code 1657 5068
.code 5753 5069
.code 3705 5070
.code 7801 5071
.code 377 5072
.code 4473 5073
.code 2425 5074
.code 6521 5075
.code 1401 5076
.code 5497 5077
.code 3449 5078
.code 7545 5079
.code 889 5080
.code 4985 5081
.code 2937 5082
.code 7033 5083
.code 1913 5084
.code 6009 5085
.code 3961 5086
.code 8057 5087
.code 249 5088
.code 4345 5089
.code 2297 5090
.code 6393 5091
.code 1273 5092
.code 5369 5093
.code 3321 5094
.code 7417 5095
.code 761 5096
.code 4857 5097
.code 2809 5098
.code 6905 5099
.code 1785 5100
.code 5881 5101
.code 3833 5102
.code 7929 5103
.code 505 5104
.code 4601 5105
.code 2553 5106
.code 6649 5107
.code 1529 5108
.code 5625 5109
.code 3577 5110
.code 7673 5111
.code 1017 5112
.code 5113 5113
.code 3065 5114
.code 7161 5115
.code 2041 5116
.code 6137 5117
.code 4089 5118
.code 8185 5119
.code 5 5120
.code 4101 5121
.code 2053 5122
.code 6149 5123
.code 1029 5124
.code 5125 5125
.code 3077 5126
.code 7173 5127
.code 517 5128
.code 4613 5129
.code 2565 5130
.code 6661 5131
.code 1541 5132
.code 5637 5133
.code 3589 5134
.code 7685 5135
.code 261 5136
.code 4357 5137
.code 2309 5138
.code 6405 5139
.code 1285 5140
.code 5381 5141
.code 3333 5142
.code 7429 5143
.code 773 5144
.code 4869 5145
.code 2821 5146
.code 6917 5147
.code 1797 5148
.code 5893 5149
.code 3845 5150
.code 7941 5151
.code 133 5152
.code 4229 5153
.code 2181 5154
.code 6277 5155
.code 1157 5156
.code 5253 5157
.code 3205 5158
.code 7301 5159
.code 645 5160
.code 4741 5161
.code 2693 5162
.code 6789 5163
.code 1669 5164
.code 5765 5165
.code 3717 5166
.code 7813 5167
.code 389 5168
.code 4485 5169
.code 2437 5170
.code 6533 5171
.code 1413 5172
.code 5509 5173
.code 3461 5174
.code 7557 5175
.code 901 5176
.code 4997 5177
.code 2949 5178
.code 7045 5179
.code 1925 5180
.code 6021 5181
.code 3973 5182
.code 8069 5183
.code 69 5184
.code 4165 5185
.code 2117 5186
.code 6213 5187
.code 1093 5188
.code 5189 5189
.code 3141 5190
.code 7237 5191
.code 581 5192
.code 4677 5193
.code 2629 5194
.code 6725 5195
.code 1605 5196
.code 5701 5197
.code 3653 5198
.code 7749 5199
.code 325 5200
.code 4421 5201
.code 2373 5202
.code 6469 5203
.code 1349 5204
.code 5445 5205
.code 3397 5206
.code 7493 5207
.code 837 5208
.code 4933 5209
.code 2885 5210
.code 6981 5211
.code 1861 5212
.code 5957 5213
.code 3909 5214
.code 8005 5215
.code 197 5216
.code 4293 5217
.code 2245 5218
.code 6341 5219
.code 1221 5220
.code 5317 5221
.code 3269 5222
.code 7365 5223
.code 709 5224
.code 4805 5225
.code 2757 5226
.code 6853 5227
.code 1733 5228
.code 5829 5229
.code 3781 5230
.code 7877 5231
.code 453 5232
.code 4549 5233
.code 2501 5234
.code 6597 5235
.code 1477 5236
.code 5573 5237
.code 3525 5238
.code 7621 5239
.code 965 5240
.code 5061 5241
.code 3013 5242
.code 7109 5243
.code 1989 5244
.code 6085 5245
.code 4037 5246
.code 8133 5247
.code 37 5248
.code 4133 5249
.code 2085 5250
.code 6181 5251
.code 1061 5252
.code 5157 5253
.code 3109 5254
.code 7205 5255
.code 549 5256
.code 4645 5257
.code 2597 5258
.code 6693 5259
.code 1573 5260
.code 5669 5261
.code 3621 5262
.code 7717 5263
.code 293 5264
.code 4389 5265
.code 2341 5266
.code 6437 5267
.code 1317 5268
.code 5413 5269
.code 3365 5270
.code 7461 5271
.code 805 5272
.code 4901 5273
.code 2853 5274
.code 6949 5275
.code 1829 5276
.code 5925 5277
.code 3877 5278
.code 7973 5279
.code 165 5280
.code 4261 5281
.code 2213 5282
.code 6309 5283
.code 1189 5284
.code 5285 5285
.code 3237 5286
.code 7333 5287
.code 677 5288
.code 4773 5289
.code 2725 5290
.code 6821 5291
.code 1701 5292
.code 5797 5293
.code 3749 5294
.code 7845 5295
.code 421 5296
.code 4517 5297
.code 2469 5298
.code 6565 5299
.code 1445 5300
.code 5541 5301
.code 3493 5302
.code 7589 5303
.code 933 5304
.code 5029 5305
.code 2981 5306
.code 7077 5307
.code 1957 5308
.code 6053 5309
.code 4005 5310
.code 8101 5311
.code 101 5312
.code 4197 5313
.code 2149 5314
.code 6245 5315
.code 1125 5316
.code 5221 5317
.code 3173 5318
.code 7269 5319
.code 613 5320
.code 4709 5321
.code 2661 5322
.code 6757 5323
.code 1637 5324
.code 5733 5325
.code 3685 5326
.code 7781 5327
.code 357 5328
.code 4453 5329
.code 2405 5330
.code 6501 5331
.code 1381 5332
.code 5477 5333
.code 3429 5334
.code 7525 5335
.code 869 5336
.code 4965 5337
.code 2917 5338
.code 7013 5339
.code 1893 5340
.code 5989 5341
.code 3941 5342
.code 8037 5343
.code 229 5344
.code 4325 5345
.code 2277 5346
.code 6373 5347
.code 1253 5348
.code 5349 5349
.code 3301 5350
.code 7397 5351
.code 741 5352
.code 4837 5353
.code 2789 5354
.code 6885 5355
.code 1765 5356
.code 5861 5357
.code 3813 5358
.code 7909 5359
.code 485 5360
.code 4581 5361
.code 2533 5362
.code 6629 5363
.code 1509 5364
.code 5605 5365
.code 3557 5366
.code 7653 5367
.code 997 5368
.code 5093 5369
.code 3045 5370
.code 7141 5371
.code 2021 5372
.code 6117 5373
.code 4069 5374
.code 8165 5375
.code 21 5376
.code 4117 5377
.code 2069 5378
.code 6165 5379
.code 1045 5380
.code 5141 5381
.code 3093 5382
.code 7189 5383
.code 533 5384
.code 4629 5385
.code 2581 5386
.code 6677 5387
.code 1557 5388
.code 5653 5389
.code 3605 5390
.code 7701 5391
.code 277 5392
.code 4373 5393
.code 2325 5394
.code 6421 5395
.code 1301 5396
.code 5397 5397
.code 3349 5398
.code 7445 5399
.code 789 5400
.code 4885 5401
.code 2837 5402
.code 6933 5403
.code 1813 5404
.code 5909 5405
.code 3861 5406
.code 7957 5407
.code 149 5408
.code 4245 5409
.code 2197 5410
.code 6293 5411
.code 1173 5412
.code 5269 5413
.code 3221 5414
.code 7317 5415
.code 661 5416
.code 4757 5417
.code 2709 5418
.code 6805 5419
.code 1685 5420
.code 5781 5421
.code 3733 5422
.code 7829 5423
.code 405 5424
.code 4501 5425
.code 2453 5426
.code 6549 5427
.code 1429 5428
.code 5525 5429
.code 3477 5430
.code 7573 5431
.code 917 5432
.code 5013 5433
.code 2965 5434
.code 7061 5435
.code 1941 5436
.code 6037 5437
.code 3989 5438
.code 8085 5439
.code 85 5440
.code 4181 5441
.code 2133 5442
.code 6229 5443
.code 1109 5444
.code 5205 5445
.code 3157 5446
.code 7253 5447
.code 597 5448
.code 4693 5449
.code 2645 5450
.code 6741 5451
.code 1621 5452
.code 5717 5453
.code 3669 5454
.code 7765 5455
.code 341 5456
.code 4437 5457
.code 2389 5458
.code 6485 5459
.code 1365 5460
.code 5461 5461
.code 3413 5462
.code 7509 5463
.code 853 5464
.code 4949 5465
.code 2901 5466
.code 6997 5467
.code 1877 5468
.code 5973 5469
.code 3925 5470
.code 8021 5471
.code 213 5472
.code 4309 5473
.code 2261 5474
.code 6357 5475
.code 1237 5476
.code 5333 5477
.code 3285 5478
.code 7381 5479
.code 725 5480
.code 4821 5481
.code 2773 5482
.code 6869 5483
.code 1749 5484
.code 5845 5485
.code 3797 5486
.code 7893 5487
.code 469 5488
.code 4565 5489
.code 2517 5490
.code 6613 5491
.code 1493 5492
.code 5589 5493
.code 3541 5494
.code 7637 5495
.code 981 5496
.code 5077 5497
.code 3029 5498
.code 7125 5499
.code 2005 5500
.code 6101 5501
.code 4053 5502
.code 8149 5503
.code 53 5504
.code 4149 5505
.code 2101 5506
.code 6197 5507
.code 1077 5508
.code 5173 5509
.code 3125 5510
.code 7221 5511
.code 565 5512
.code 4661 5513
.code 2613 5514
.code 6709 5515
.code 1589 5516
.code 5685 5517
.code 3637 5518
.code 7733 5519
.code 309 5520
.code 4405 5521
.code 2357 5522
.code 6453 5523
.code 1333 5524
.code 5429 5525
.code 3381 5526
.code 7477 5527
.code 821 5528
.code 4917 5529
.code 2869 5530
.code 6965 5531
.code 1845 5532
.code 5941 5533
.code 3893 5534
.code 7989 5535
.code 181 5536
.code 4277 5537
.code 2229 5538
.code 6325 5539
.code 1205 5540
.code 5301 5541
.code 3253 5542
.code 7349 5543
.code 693 5544
.code 4789 5545
.code 2741 5546
.code 6837 5547
.code 1717 5548
.code 5813 5549
.code 3765 5550
.code 7861 5551
.code 437 5552
.code 4533 5553
.code 2485 5554
.code 6581 5555
.code 1461 5556
.code 5557 5557
.code 3509 5558
.code 7605 5559
.code 949 5560
.code 5045 5561
.code 2997 5562
.code 7093 5563
.code 1973 5564
.code 6069 5565
.code 4021 5566
.code 8117 5567
.code 117 5568
.code 4213 5569
.code 2165 5570
.code 6261 5571
.code 1141 5572
.code 5237 5573
.code 3189 5574
.code 7285 5575
.code 629 5576
.code 4725 5577
.code 2677 5578
.code 6773 5579
.code 1653 5580
.code 5749 5581
.code 3701 5582
.code 7797 5583
.code 373 5584
.code 4469 5585
.code 2421 5586
.code 6517 5587
.code 1397 5588
.code 5493 5589
.code 3445 5590
.code 7541 5591
.code 885 5592
.code 4981 5593
.code 2933 5594
.code 7029 5595
.code 1909 5596
.code 6005 5597
.code 3957 5598
.code 8053 5599
.code 245 5600
.code 4341 5601
.code 2293 5602
.code 6389 5603
.code 1269 5604
.code 5365 5605
.code 3317 5606
.code 7413 5607
.code 757 5608
.code 4853 5609
.code 2805 5610
.code 6901 5611
.code 1781 5612
.code 5877 5613
.code 3829 5614
.code 7925 5615
.code 501 5616
.code 4597 5617
.code 2549 5618
.code 6645 5619
.code 1525 5620
.code 5621 5621
.code 3573 5622
.code 7669 5623
.code 1013 5624
.code 5109 5625
.code 3061 5626
.code 7157 5627
.code 2037 5628
.code 6133 5629
.code 4085 5630
.code 8181 5631
.code 13 5632
.code 4109 5633
.code 2061 5634
.code 6157 5635
.code 1037 5636
.code 5133 5637
.code 3085 5638
.code 7181 5639
.code 525 5640
.code 4621 5641
.code 2573 5642
.code 6669 5643
.code 1549 5644
.code 5645 5645
.code 3597 5646
.code 7693 5647
.code 269 5648
.code 4365 5649
.code 2317 5650
.code 6413 5651
.code 1293 5652
.code 5389 5653
.code 3341 5654
.code 7437 5655
.code 781 5656
.code 4877 5657
.code 2829 5658
.code 6925 5659
.code 1805 5660
.code 5901 5661
.code 3853 5662
.code 7949 5663
.code 141 5664
.code 4237 5665
.code 2189 5666
.code 6285 5667
.code 1165 5668
.code 5261 5669
.code 3213 5670
.code 7309 5671
.code 653 5672
.code 4749 5673
.code 2701 5674
.code 6797 5675
.code 1677 5676
.code 5773 5677
.code 3725 5678
.code 7821 5679
.code 397 5680
.code 4493 5681
.code 2445 5682
.code 6541 5683
.code 1421 5684
.code 5517 5685
.code 3469 5686
.code 7565 5687
.code 909 5688
.code 5005 5689
.code 2957 5690
.code 7053 5691
.code 1933 5692
.code 6029 5693
.code 3981 5694
.code 8077 5695
.code 77 5696
.code 4173 5697
.code 2125 5698
.code 6221 5699
.code 1101 5700
.code 5197 5701
.code 3149 5702
.code 7245 5703
.code 589 5704
.code 4685 5705
.code 2637 5706
.code 6733 5707
.code 1613 5708
.code 5709 5709
.code 3661 5710
.code 7757 5711
.code 333 5712
.code 4429 5713
.code 2381 5714
.code 6477 5715
.code 1357 5716
.code 5453 5717
.code 3405 5718
.code 7501 5719
.code 845 5720
.code 4941 5721
.code 2893 5722
.code 6989 5723
.code 1869 5724
.code 5965 5725
.code 3917 5726
.code 8013 5727
.code 205 5728
.code 4301 5729
.code 2253 5730
.code 6349 5731
.code 1229 5732
.code 5325 5733
.code 3277 5734
.code 7373 5735
.code 717 5736
.code 4813 5737
.code 2765 5738
.code 6861 5739
.code 1741 5740
.code 5837 5741
.code 3789 5742
.code 7885 5743
.code 461 5744
.code 4557 5745
.code 2509 5746
.code 6605 5747
.code 1485 5748
.code 5581 5749
.code 3533 5750
.code 7629 5751
.code 973 5752
.code 5069 5753
.code 3021 5754
.code 7117 5755
.code 1997 5756
.code 6093 5757
.code 4045 5758
.code 8141 5759
.code 45 5760
.code 4141 5761
.code 2093 5762
.code 6189 5763
.code 1069 5764
.code 5165 5765
.code 3117 5766
.code 7213 5767
.code 557 5768
.code 4653 5769
.code 2605 5770
.code 6701 5771
.code 1581 5772
.code 5677 5773
.code 3629 5774
.code 7725 5775
.code 301 5776
.code 4397 5777
.code 2349 5778
.code 6445 5779
.code 1325 5780
.code 5421 5781
.code 3373 5782
.code 7469 5783
.code 813 5784
.code 4909 5785
.code 2861 5786
.code 6957 5787
.code 1837 5788
.code 5933 5789
.code 3885 5790
.code 7981 5791
.code 173 5792
.code 4269 5793
.code 2221 5794
.code 6317 5795
.code 1197 5796
.code 5293 5797
.code 3245 5798
.code 7341 5799
.code 685 5800
.code 4781 5801
.code 2733 5802
.code 6829 5803
.code 1709 5804
.code 5805 5805
.code 3757 5806
.code 7853 5807
.code 429 5808
.code 4525 5809
.code 2477 5810
.code 6573 5811
.code 1453 5812
.code 5549 5813
.code 3501 5814
.code 7597 5815
.code 941 5816
.code 5037 5817
.code 2989 5818
.code 7085 5819
.code 1965 5820
.code 6061 5821
.code 4013 5822
.code 8109 5823
.code 109 5824
.code 4205 5825
.code 2157 5826
.code 6253 5827
.code 1133 5828
.code 5229 5829
.code 3181 5830
.code 7277 5831
.code 621 5832
.code 4717 5833
.code 2669 5834
.code 6765 5835
.code 1645 5836
.code 5741 5837
.code 3693 5838
.code 7789 5839
.code 365 5840
.code 4461 5841
.code 2413 5842
.code 6509 5843
.code 1389 5844
.code 5485 5845
.code 3437 5846
.code 7533 5847
.code 877 5848
.code 4973 5849
.code 2925 5850
.code 7021 5851
.code 1901 5852
.code 5997 5853
.code 3949 5854
.code 8045 5855
.code 237 5856
.code 4333 5857
.code 2285 5858
.code 6381 5859
.code 1261 5860
.code 5357 5861
.code 3309 5862
.code 7405 5863
.code 749 5864
.code 4845 5865
.code 2797 5866
.code 6893 5867
.code 1773 5868
.code 5869 5869
.code 3821 5870
.code 7917 5871
.code 493 5872
.code 4589 5873
.code 2541 5874
.code 6637 5875
.code 1517 5876
.code 5613 5877
.code 3565 5878
.code 7661 5879
.code 1005 5880
.code 5101 5881
.code 3053 5882
.code 7149 5883
.code 2029 5884
.code 6125 5885
.code 4077 5886
.code 8173 5887
.code 29 5888
.code 4125 5889
.code 2077 5890
.code 6173 5891
.code 1053 5892
.code 5149 5893
.code 3101 5894
.code 7197 5895
.code 541 5896
.code 4637 5897
.code 2589 5898
.code 6685 5899
.code 1565 5900
.code 5661 5901
.code 3613 5902
.code 7709 5903
.code 285 5904
.code 4381 5905
.code 2333 5906
.code 6429 5907
.code 1309 5908
.code 5405 5909
.code 3357 5910
.code 7453 5911
.code 797 5912
.code 4893 5913
.code 2845 5914
.code 6941 5915
.code 1821 5916
.code 5917 5917
.code 3869 5918
.code 7965 5919
.code 157 5920
.code 4253 5921
.code 2205 5922
.code 6301 5923
.code 1181 5924
.code 5277 5925
.code 3229 5926
.code 7325 5927
.code 669 5928
.code 4765 5929
.code 2717 5930
.code 6813 5931
.code 1693 5932
.code 5789 5933
.code 3741 5934
.code 7837 5935
.code 413 5936
.code 4509 5937
.code 2461 5938
.code 6557 5939
.code 1437 5940
.code 5533 5941
.code 3485 5942
.code 7581 5943
.code 925 5944
.code 5021 5945
.code 2973 5946
.code 7069 5947
.code 1949 5948
.code 6045 5949
.code 3997 5950
.code 8093 5951
.code 93 5952
.code 4189 5953
.code 2141 5954
.code 6237 5955
.code 1117 5956
.code 5213 5957
.code 3165 5958
.code 7261 5959
.code 605 5960
.code 4701 5961
.code 2653 5962
.code 6749 5963
.code 1629 5964
.code 5725 5965
.code 3677 5966
.code 7773 5967
.code 349 5968
.code 4445 5969
.code 2397 5970
.code 6493 5971
.code 1373 5972
.code 5469 5973
.code 3421 5974
.code 7517 5975
.code 861 5976
.code 4957 5977
.code 2909 5978
.code 7005 5979
.code 1885 5980
.code 5981 5981
.code 3933 5982
.code 8029 5983
.code 221 5984
.code 4317 5985
.code 2269 5986
.code 6365 5987
.code 1245 5988
.code 5341 5989
.code 3293 5990
.code 7389 5991
.code 733 5992
.code 4829 5993
.code 2781 5994
.code 6877 5995
.code 1757 5996
.code 5853 5997
.code 3805 5998
.code 7901 5999
.code 477 6000
.code 4573 6001
.code 2525 6002
.code 6621 6003
.code 1501 6004
.code 5597 6005
.code 3549 6006
.code 7645 6007
.code 989 6008
.code 5085 6009
.code 3037 6010
.code 7133 6011
.code 2013 6012
.code 6109 6013
.code 4061 6014
.code 8157 6015
.code 61 6016
.code 4157 6017
.code 2109 6018
.code 6205 6019
.code 1085 6020
.code 5181 6021
.code 3133 6022
.code 7229 6023
.code 573 6024
.code 4669 6025
.code 2621 6026
.code 6717 6027
.code 1597 6028
.code 5693 6029
.code 3645 6030
.code 7741 6031
.code 317 6032
.code 4413 6033
.code 2365 6034
.code 6461 6035
.code 1341 6036
.code 5437 6037
.code 3389 6038
.code 7485 6039
.code 829 6040
.code 4925 6041
.code 2877 6042
.code 6973 6043
.code 1853 6044
.code 5949 6045
.code 3901 6046
.code 7997 6047
.code 189 6048
.code 4285 6049
.code 2237 6050
.code 6333 6051
.code 1213 6052
.code 5309 6053
.code 3261 6054
.code 7357 6055
.code 701 6056
.code 4797 6057
.code 2749 6058
.code 6845 6059
.code 1725 6060
.code 5821 6061
.code 3773 6062
.code 7869 6063
.code 445 6064
.code 4541 6065
.code 2493 6066
.code 6589 6067
.code 1469 6068
.code 5565 6069
.code 3517 6070
.code 7613 6071
.code 957 6072
.code 5053 6073
.code 3005 6074
.code 7101 6075
.code 1981 6076
.code 6077 6077
.code 4029 6078
.code 8125 6079
.code 125 6080
.code 4221 6081
.code 2173 6082
.code 6269 6083
.code 1149 6084
.code 5245 6085
.code 3197 6086
.code 7293 6087
.code 637 6088
.code 4733 6089
.code 2685 6090
.code 6781 6091
.code 1661 6092
.code 5757 6093
.code 3709 6094
.code 7805 6095
.code 381 6096
.code 4477 6097
.code 2429 6098
.code 6525 6099
.code 1405 6100
.code 5501 6101
.code 3453 6102
.code 7549 6103
.code 893 6104
.code 4989 6105
.code 2941 6106
.code 7037 6107
.code 1917 6108
.code 6013 6109
.code 3965 6110
.code 8061 6111
.code 253 6112
.code 4349 6113
.code 2301 6114
.code 6397 6115
.code 1277 6116
.code 5373 6117
.code 3325 6118
.code 7421 6119
.code 765 6120
.code 4861 6121
.code 2813 6122
.code 6909 6123
.code 1789 6124
.code 5885 6125
.code 3837 6126
.code 7933 6127
.code 509 6128
.code 4605 6129
.code 2557 6130
.code 6653 6131
.code 1533 6132
.code 5629 6133
.code 3581 6134
.code 7677 6135
.code 1021 6136
.code 5117 6137
.code 3069 6138
.code 7165 6139
.code 2045 6140
.code 6141 6141
.code 4093 6142
.code 8189 6143
.code 3 6144
.code 4099 6145
.code 2051 6146
.code 6147 6147
.code 1027 6148
.code 5123 6149
.code 3075 6150
.code 7171 6151
.code 515 6152
.code 4611 6153
.code 2563 6154
.code 6659 6155
.code 1539 6156
.code 5635 6157
.code 3587 6158
.code 7683 6159
.code 259 6160
.code 4355 6161
.code 2307 6162
.code 6403 6163
.code 1283 6164
.code 5379 6165
.code 3331 6166
.code 7427 6167
.code 771 6168
.code 4867 6169
.code 2819 6170
.code 6915 6171
.code 1795 6172
.code 5891 6173
.code 3843 6174
.code 7939 6175
.code 131 6176
.code 4227 6177
.code 2179 6178
.code 6275 6179
.code 1155 6180
.code 5251 6181
.code 3203 6182
.code 7299 6183
.code 643 6184
.code 4739 6185
.code 2691 6186
.code 6787 6187
.code 1667 6188
.code 5763 6189
.code 3715 6190
.code 7811 6191
.code 387 6192
.code 4483 6193
.code 2435 6194
.code 6531 6195
.code 1411 6196
.code 5507 6197
.code 3459 6198
.code 7555 6199
.code 899 6200
.code 4995 6201
.code 2947 6202
.code 7043 6203
.code 1923 6204
.code 6019 6205
.code 3971 6206
.code 8067 6207
.code 67 6208
.code 4163 6209
.code 2115 6210
.code 6211 6211
.code 1091 6212
.code 5187 6213
.code 3139 6214
.code 7235 6215
.code 579 6216
.code 4675 6217
.code 2627 6218
.code 6723 6219
.code 1603 6220
.code 5699 6221
.code 3651 6222
.code 7747 6223
.code 323 6224
.code 4419 6225
.code 2371 6226
.code 6467 6227
.code 1347 6228
.code 5443 6229
.code 3395 6230
.code 7491 6231
.code 835 6232
.code 4931 6233
.code 2883 6234
.code 6979 6235
.code 1859 6236
.code 5955 6237
.code 3907 6238
.code 8003 6239
.code 195 6240
.code 4291 6241
.code 2243 6242
.code 6339 6243
.code 1219 6244
.code 5315 6245
.code 3267 6246
.code 7363 6247
.code 707 6248
.code 4803 6249
.code 2755 6250
.code 6851 6251
.code 1731 6252
.code 5827 6253
.code 3779 6254
.code 7875 6255
.code 451 6256
.code 4547 6257
.code 2499 6258
.code 6595 6259
.code 1475 6260
.code 5571 6261
.code 3523 6262
.code 7619 6263
.code 963 6264
.code 5059 6265
.code 3011 6266
.code 7107 6267
.code 1987 6268
.code 6083 6269
.code 4035 6270
.code 8131 6271
.code 35 6272
.code 4131 6273
.code 2083 6274
.code 6179 6275
.code 1059 6276
.code 5155 6277
.code 3107 6278
.code 7203 6279
.code 547 6280
.code 4643 6281
.code 2595 6282
.code 6691 6283
.code 1571 6284
.code 5667 6285
.code 3619 6286
.code 7715 6287
.code 291 6288
.code 4387 6289
.code 2339 6290
.code 6435 6291
.code 1315 6292
.code 5411 6293
.code 3363 6294
.code 7459 6295
.code 803 6296
.code 4899 6297
.code 2851 6298
.code 6947 6299
.code 1827 6300
.code 5923 6301
.code 3875 6302
.code 7971 6303
.code 163 6304
.code 4259 6305
.code 2211 6306
.code 6307 6307
.code 1187 6308
.code 5283 6309
.code 3235 6310
.code 7331 6311
.code 675 6312
.code 4771 6313
.code 2723 6314
.code 6819 6315
.code 1699 6316
.code 5795 6317
.code 3747 6318
.code 7843 6319
.code 419 6320
.code 4515 6321
.code 2467 6322
.code 6563 6323
.code 1443 6324
.code 5539 6325
.code 3491 6326
.code 7587 6327
.code 931 6328
.code 5027 6329
.code 2979 6330
.code 7075 6331
.code 1955 6332
.code 6051 6333
.code 4003 6334
.code 8099 6335
.code 99 6336
.code 4195 6337
.code 2147 6338
.code 6243 6339
.code 1123 6340
.code 5219 6341
.code 3171 6342
.code 7267 6343
.code 611 6344
.code 4707 6345
.code 2659 6346
.code 6755 6347
.code 1635 6348
.code 5731 6349
.code 3683 6350
.code 7779 6351
.code 355 6352
.code 4451 6353
.code 2403 6354
.code 6499 6355
.code 1379 6356
.code 5475 6357
.code 3427 6358
.code 7523 6359
.code 867 6360
.code 4963 6361
.code 2915 6362
.code 7011 6363
.code 1891 6364
.code 5987 6365
.code 3939 6366
.code 8035 6367
.code 227 6368
.code 4323 6369
.code 2275 6370
.code 6371 6371
.code 1251 6372
.code 5347 6373
.code 3299 6374
.code 7395 6375
.code 739 6376
.code 4835 6377
.code 2787 6378
.code 6883 6379
.code 1763 6380
.code 5859 6381
.code 3811 6382
.code 7907 6383
.code 483 6384
.code 4579 6385
.code 2531 6386
.code 6627 6387
.code 1507 6388
.code 5603 6389
.code 3555 6390
.code 7651 6391
.code 995 6392
.code 5091 6393
.code 3043 6394
.code 7139 6395
.code 2019 6396
.code 6115 6397
.code 4067 6398
.code 8163 6399
.code 19 6400
.code 4115 6401
.code 2067 6402
.code 6163 6403
.code 1043 6404
.code 5139 6405
.code 3091 6406
.code 7187 6407
.code 531 6408
.code 4627 6409
.code 2579 6410
.code 6675 6411
.code 1555 6412
.code 5651 6413
.code 3603 6414
.code 7699 6415
.code 275 6416
.code 4371 6417
.code 2323 6418
.code 6419 6419
.code 1299 6420
.code 5395 6421
.code 3347 6422
.code 7443 6423
.code 787 6424
.code 4883 6425
.code 2835 6426
.code 6931 6427
.code 1811 6428
.code 5907 6429
.code 3859 6430
.code 7955 6431
.code 147 6432
.code 4243 6433
.code 2195 6434
.code 6291 6435
.code 1171 6436
.code 5267 6437
.code 3219 6438
.code 7315 6439
.code 659 6440
.code 4755 6441
.code 2707 6442
.code 6803 6443
.code 1683 6444
.code 5779 6445
.code 3731 6446
.code 7827 6447
.code 403 6448
.code 4499 6449
.code 2451 6450
.code 6547 6451
.code 1427 6452
.code 5523 6453
.code 3475 6454
.code 7571 6455
.code 915 6456
.code 5011 6457
.code 2963 6458
.code 7059 6459
.code 1939 6460
.code 6035 6461
.code 3987 6462
.code 8083 6463
.code 83 6464
.code 4179 6465
.code 2131 6466
.code 6227 6467
.code 1107 6468
.code 5203 6469
.code 3155 6470
.code 7251 6471
.code 595 6472
.code 4691 6473
.code 2643 6474
.code 6739 6475
.code 1619 6476
.code 5715 6477
.code 3667 6478
.code 7763 6479
.code 339 6480
.code 4435 6481
.code 2387 6482
.code 6483 6483
.code 1363 6484
.code 5459 6485
.code 3411 6486
.code 7507 6487
.code 851 6488
.code 4947 6489
.code 2899 6490
.code 6995 6491
.code 1875 6492
.code 5971 6493
.code 3923 6494
.code 8019 6495
.code 211 6496
.code 4307 6497
.code 2259 6498
.code 6355 6499
.code 1235 6500
.code 5331 6501
.code 3283 6502
.code 7379 6503
.code 723 6504
.code 4819 6505
.code 2771 6506
.code 6867 6507
.code 1747 6508
.code 5843 6509
.code 3795 6510
.code 7891 6511
.code 467 6512
.code 4563 6513
.code 2515 6514
.code 6611 6515
.code 1491 6516
.code 5587 6517
.code 3539 6518
.code 7635 6519
.code 979 6520
.code 5075 6521
.code 3027 6522
.code 7123 6523
.code 2003 6524
.code 6099 6525
.code 4051 6526
.code 8147 6527
.code 51 6528
.code 4147 6529
.code 2099 6530
.code 6195 6531
.code 1075 6532
.code 5171 6533
.code 3123 6534
.code 7219 6535
.code 563 6536
.code 4659 6537
.code 2611 6538
.code 6707 6539
.code 1587 6540
.code 5683 6541
.code 3635 6542
.code 7731 6543
.code 307 6544
.code 4403 6545
.code 2355 6546
.code 6451 6547
.code 1331 6548
.code 5427 6549
.code 3379 6550
.code 7475 6551
.code 819 6552
.code 4915 6553
.code 2867 6554
.code 6963 6555
.code 1843 6556
.code 5939 6557
.code 3891 6558
.code 7987 6559
.code 179 6560
.code 4275 6561
.code 2227 6562
.code 6323 6563
.code 1203 6564
.code 5299 6565
.code 3251 6566
.code 7347 6567
.code 691 6568
.code 4787 6569
.code 2739 6570
.code 6835 6571
.code 1715 6572
.code 5811 6573
.code 3763 6574
.code 7859 6575
.code 435 6576
.code 4531 6577
.code 2483 6578
.code 6579 6579
.code 1459 6580
.code 5555 6581
.code 3507 6582
.code 7603 6583
.code 947 6584
.code 5043 6585
.code 2995 6586
.code 7091 6587
.code 1971 6588
.code 6067 6589
.code 4019 6590
.code 8115 6591
.code 115 6592
.code 4211 6593
.code 2163 6594
.code 6259 6595
.code 1139 6596
.code 5235 6597
.code 3187 6598
.code 7283 6599
.code 627 6600
.code 4723 6601
.code 2675 6602
.code 6771 6603
.code 1651 6604
.code 5747 6605
.code 3699 6606
.code 7795 6607
.code 371 6608
.code 4467 6609
.code 2419 6610
.code 6515 6611
.code 1395 6612
.code 5491 6613
.code 3443 6614
.code 7539 6615
.code 883 6616
.code 4979 6617
.code 2931 6618
.code 7027 6619
.code 1907 6620
.code 6003 6621
.code 3955 6622
.code 8051 6623
.code 243 6624
.code 4339 6625
.code 2291 6626
.code 6387 6627
.code 1267 6628
.code 5363 6629
.code 3315 6630
.code 7411 6631
.code 755 6632
.code 4851 6633
.code 2803 6634
.code 6899 6635
.code 1779 6636
.code 5875 6637
.code 3827 6638
.code 7923 6639
.code 499 6640
.code 4595 6641
.code 2547 6642
.code 6643 6643
.code 1523 6644
.code 5619 6645
.code 3571 6646
.code 7667 6647
.code 1011 6648
.code 5107 6649
.code 3059 6650
.code 7155 6651
.code 2035 6652
.code 6131 6653
.code 4083 6654
.code 8179 6655
.code 11 6656
.code 4107 6657
.code 2059 6658
.code 6155 6659
.code 1035 6660
.code 5131 6661
.code 3083 6662
.code 7179 6663
.code 523 6664
.code 4619 6665
.code 2571 6666
.code 6667 6667
.code 1547 6668
.code 5643 6669
.code 3595 6670
.code 7691 6671
.code 267 6672
.code 4363 6673
.code 2315 6674
.code 6411 6675
.code 1291 6676
.code 5387 6677
.code 3339 6678
.code 7435 6679
.code 779 6680
.code 4875 6681
.code 2827 6682
.code 6923 6683
.code 1803 6684
.code 5899 6685
.code 3851 6686
.code 7947 6687
.code 139 6688
.code 4235 6689
.code 2187 6690
.code 6283 6691
.code 1163 6692
.code 5259 6693
.code 3211 6694
.code 7307 6695
.code 651 6696
.code 4747 6697
.code 2699 6698
.code 6795 6699
.code 1675 6700
.code 5771 6701
.code 3723 6702
.code 7819 6703
.code 395 6704
.code 4491 6705
.code 2443 6706
.code 6539 6707
.code 1419 6708
.code 5515 6709
.code 3467 6710
.code 7563 6711
.code 907 6712
.code 5003 6713
.code 2955 6714
.code 7051 6715
.code 1931 6716
.code 6027 6717
.code 3979 6718
.code 8075 6719
.code 75 6720
.code 4171 6721
.code 2123 6722
.code 6219 6723
.code 1099 6724
.code 5195 6725
.code 3147 6726
.code 7243 6727
.code 587 6728
.code 4683 6729
.code 2635 6730
.code 6731 6731
.code 1611 6732
.code 5707 6733
.code 3659 6734
.code 7755 6735
.code 331 6736
.code 4427 6737
.code 2379 6738
.code 6475 6739
.code 1355 6740
.code 5451 6741
.code 3403 6742
.code 7499 6743
.code 843 6744
.code 4939 6745
.code 2891 6746
.code 6987 6747
.code 1867 6748
.code 5963 6749
.code 3915 6750
.code 8011 6751
.code 203 6752
.code 4299 6753
.code 2251 6754
.code 6347 6755
.code 1227 6756
.code 5323 6757
.code 3275 6758
.code 7371 6759
.code 715 6760
.code 4811 6761
.code 2763 6762
.code 6859 6763
.code 1739 6764
.code 5835 6765
.code 3787 6766
.code 7883 6767
.code 459 6768
.code 4555 6769
.code 2507 6770
.code 6603 6771
.code 1483 6772
.code 5579 6773
.code 3531 6774
.code 7627 6775
.code 971 6776
.code 5067 6777
.code 3019 6778
.code 7115 6779
.code 1995 6780
.code 6091 6781
.code 4043 6782
.code 8139 6783
.code 43 6784
.code 4139 6785
.code 2091 6786
.code 6187 6787
.code 1067 6788
.code 5163 6789
.code 3115 6790
.code 7211 6791
.code 555 6792
.code 4651 6793
.code 2603 6794
.code 6699 6795
.code 1579 6796
.code 5675 6797
.code 3627 6798
.code 7723 6799
.code 299 6800
.code 4395 6801
.code 2347 6802
.code 6443 6803
.code 1323 6804
.code 5419 6805
.code 3371 6806
.code 7467 6807
.code 811 6808
.code 4907 6809
.code 2859 6810
.code 6955 6811
.code 1835 6812
.code 5931 6813
.code 3883 6814
.code 7979 6815
.code 171 6816
.code 4267 6817
.code 2219 6818
.code 6315 6819
.code 1195 6820
.code 5291 6821
.code 3243 6822
.code 7339 6823
.code 683 6824
.code 4779 6825
.code 2731 6826
.code 6827 6827
.code 1707 6828
.code 5803 6829
.code 3755 6830
.code 7851 6831
.code 427 6832
.code 4523 6833
.code 2475 6834
.code 6571 6835
.code 1451 6836
.code 5547 6837
.code 3499 6838
.code 7595 6839
.code 939 6840
.code 5035 6841
.code 2987 6842
.code 7083 6843
.code 1963 6844
.code 6059 6845
.code 4011 6846
.code 8107 6847
.code 107 6848
.code 4203 6849
.code 2155 6850
.code 6251 6851
.code 1131 6852
.code 5227 6853
.code 3179 6854
.code 7275 6855
.code 619 6856
.code 4715 6857
.code 2667 6858
.code 6763 6859
.code 1643 6860
.code 5739 6861
.code 3691 6862
.code 7787 6863
.code 363 6864
.code 4459 6865
.code 2411 6866
.code 6507 6867
.code 1387 6868
.code 5483 6869
.code 3435 6870
.code 7531 6871
.code 875 6872
.code 4971 6873
.code 2923 6874
.code 7019 6875
.code 1899 6876
.code 5995 6877
.code 3947 6878
.code 8043 6879
.code 235 6880
.code 4331 6881
.code 2283 6882
.code 6379 6883
.code 1259 6884
.code 5355 6885
.code 3307 6886
.code 7403 6887
.code 747 6888
.code 4843 6889
.code 2795 6890
.code 6891 6891
.code 1771 6892
.code 5867 6893
.code 3819 6894
.code 7915 6895
.code 491 6896
.code 4587 6897
.code 2539 6898
.code 6635 6899
.code 1515 6900
.code 5611 6901
.code 3563 6902
.code 7659 6903
.code 1003 6904
.code 5099 6905
.code 3051 6906
.code 7147 6907
.code 2027 6908
.code 6123 6909
.code 4075 6910
.code 8171 6911
.code 27 6912
.code 4123 6913
.code 2075 6914
.code 6171 6915
.code 1051 6916
.code 5147 6917
.code 3099 6918
.code 7195 6919
.code 539 6920
.code 4635 6921
.code 2587 6922
.code 6683 6923
.code 1563 6924
.code 5659 6925
.code 3611 6926
.code 7707 6927
.code 283 6928
.code 4379 6929
.code 2331 6930
.code 6427 6931
.code 1307 6932
.code 5403 6933
.code 3355 6934
.code 7451 6935
.code 795 6936
.code 4891 6937
.code 2843 6938
.code 6939 6939
.code 1819 6940
.code 5915 6941
.code 3867 6942
.code 7963 6943
.code 155 6944
.code 4251 6945
.code 2203 6946
.code 6299 6947
.code 1179 6948
.code 5275 6949
.code 3227 6950
.code 7323 6951
.code 667 6952
.code 4763 6953
.code 2715 6954
.code 6811 6955
.code 1691 6956
.code 5787 6957
.code 3739 6958
.code 7835 6959
.code 411 6960
.code 4507 6961
.code 2459 6962
.code 6555 6963
.code 1435 6964
.code 5531 6965
.code 3483 6966
.code 7579 6967
.code 923 6968
.code 5019 6969
.code 2971 6970
.code 7067 6971
.code 1947 6972
.code 6043 6973
.code 3995 6974
.code 8091 6975
.code 91 6976
.code 4187 6977
.code 2139 6978
.code 6235 6979
.code 1115 6980
.code 5211 6981
.code 3163 6982
.code 7259 6983
.code 603 6984
.code 4699 6985
.code 2651 6986
.code 6747 6987
.code 1627 6988
.code 5723 6989
.code 3675 6990
.code 7771 6991
.code 347 6992
.code 4443 6993
.code 2395 6994
.code 6491 6995
.code 1371 6996
.code 5467 6997
.code 3419 6998
.code 7515 6999
.code 859 7000
.code 4955 7001
.code 2907 7002
.code 7003 7003
.code 1883 7004
.code 5979 7005
.code 3931 7006
.code 8027 7007
.code 219 7008
.code 4315 7009
.code 2267 7010
.code 6363 7011
.code 1243 7012
.code 5339 7013
.code 3291 7014
.code 7387 7015
.code 731 7016
.code 4827 7017
.code 2779 7018
.code 6875 7019
.code 1755 7020
.code 5851 7021
.code 3803 7022
.code 7899 7023
.code 475 7024
.code 4571 7025
.code 2523 7026
.code 6619 7027
.code 1499 7028
.code 5595 7029
.code 3547 7030
.code 7643 7031
.code 987 7032
.code 5083 7033
.code 3035 7034
.code 7131 7035
.code 2011 7036
.code 6107 7037
.code 4059 7038
.code 8155 7039
.code 59 7040
.code 4155 7041
.code 2107 7042
.code 6203 7043
.code 1083 7044
.code 5179 7045
.code 3131 7046
.code 7227 7047
.code 571 7048
.code 4667 7049
.code 2619 7050
.code 6715 7051
.code 1595 7052
.code 5691 7053
.code 3643 7054
.code 7739 7055
.code 315 7056
.code 4411 7057
.code 2363 7058
.code 6459 7059
.code 1339 7060
.code 5435 7061
.code 3387 7062
.code 7483 7063
.code 827 7064
.code 4923 7065
.code 2875 7066
.code 6971 7067
.code 1851 7068
.code 5947 7069
.code 3899 7070
.code 7995 7071
.code 187 7072
.code 4283 7073
.code 2235 7074
.code 6331 7075
.code 1211 7076
.code 5307 7077
.code 3259 7078
.code 7355 7079
.code 699 7080
.code 4795 7081
.code 2747 7082
.code 6843 7083
.code 1723 7084
.code 5819 7085
.code 3771 7086
.code 7867 7087
.code 443 7088
.code 4539 7089
.code 2491 7090
.code 6587 7091
.code 1467 7092
.code 5563 7093
.code 3515 7094
.code 7611 7095
.code 955 7096
.code 5051 7097
.code 3003 7098
.code 7099 7099
.code 1979 7100
.code 6075 7101
.code 4027 7102
.code 8123 7103
.code 123 7104
.code 4219 7105
.code 2171 7106
.code 6267 7107
.code 1147 7108
.code 5243 7109
.code 3195 7110
.code 7291 7111
.code 635 7112
.code 4731 7113
.code 2683 7114
.code 6779 7115
.code 1659 7116
.code 5755 7117
.code 3707 7118
.code 7803 7119
.code 379 7120
.code 4475 7121
.code 2427 7122
.code 6523 7123
.code 1403 7124
.code 5499 7125
.code 3451 7126
.code 7547 7127
.code 891 7128
.code 4987 7129
.code 2939 7130
.code 7035 7131
.code 1915 7132
.code 6011 7133
.code 3963 7134
.code 8059 7135
.code 251 7136
.code 4347 7137
.code 2299 7138
.code 6395 7139
.code 1275 7140
.code 5371 7141
.code 3323 7142
.code 7419 7143
.code 763 7144
.code 4859 7145
.code 2811 7146
.code 6907 7147
.code 1787 7148
.code 5883 7149
.code 3835 7150
.code 7931 7151
.code 507 7152
.code 4603 7153
.code 2555 7154
.code 6651 7155
.code 1531 7156
.code 5627 7157
.code 3579 7158
.code 7675 7159
.code 1019 7160
.code 5115 7161
.code 3067 7162
.code 7163 7163
.code 2043 7164
.code 6139 7165
.code 4091 7166
.code 8187 7167
.code 7 7168
.code 4103 7169
.code 2055 7170
.code 6151 7171
.code 1031 7172
.code 5127 7173
.code 3079 7174
.code 7175 7175
.code 519 7176
.code 4615 7177
.code 2567 7178
.code 6663 7179
.code 1543 7180
.code 5639 7181
.code 3591 7182
.code 7687 7183
.code 263 7184
.code 4359 7185
.code 2311 7186
.code 6407 7187
.code 1287 7188
.code 5383 7189
.code 3335 7190
.code 7431 7191
.code 775 7192
.code 4871 7193
.code 2823 7194
.code 6919 7195
.code 1799 7196
.code 5895 7197
.code 3847 7198
.code 7943 7199
.code 135 7200
.code 4231 7201
.code 2183 7202
.code 6279 7203
.code 1159 7204
.code 5255 7205
.code 3207 7206
.code 7303 7207
.code 647 7208
.code 4743 7209
.code 2695 7210
.code 6791 7211
.code 1671 7212
.code 5767 7213
.code 3719 7214
.code 7815 7215
.code 391 7216
.code 4487 7217
.code 2439 7218
.code 6535 7219
.code 1415 7220
.code 5511 7221
.code 3463 7222
.code 7559 7223
.code 903 7224
.code 4999 7225
.code 2951 7226
.code 7047 7227
.code 1927 7228
.code 6023 7229
.code 3975 7230
.code 8071 7231
.code 71 7232
.code 4167 7233
.code 2119 7234
.code 6215 7235
.code 1095 7236
.code 5191 7237
.code 3143 7238
.code 7239 7239
.code 583 7240
.code 4679 7241
.code 2631 7242
.code 6727 7243
.code 1607 7244
.code 5703 7245
.code 3655 7246
.code 7751 7247
.code 327 7248
.code 4423 7249
.code 2375 7250
.code 6471 7251
.code 1351 7252
.code 5447 7253
.code 3399 7254
.code 7495 7255
.code 839 7256
.code 4935 7257
.code 2887 7258
.code 6983 7259
.code 1863 7260
.code 5959 7261
.code 3911 7262
.code 8007 7263
.code 199 7264
.code 4295 7265
.code 2247 7266
.code 6343 7267
.code 1223 7268
.code 5319 7269
.code 3271 7270
.code 7367 7271
.code 711 7272
.code 4807 7273
.code 2759 7274
.code 6855 7275
.code 1735 7276
.code 5831 7277
.code 3783 7278
.code 7879 7279
.code 455 7280
.code 4551 7281
.code 2503 7282
.code 6599 7283
.code 1479 7284
.code 5575 7285
.code 3527 7286
.code 7623 7287
.code 967 7288
.code 5063 7289
.code 3015 7290
.code 7111 7291
.code 1991 7292
.code 6087 7293
.code 4039 7294
.code 8135 7295
.code 39 7296
.code 4135 7297
.code 2087 7298
.code 6183 7299
.code 1063 7300
.code 5159 7301
.code 3111 7302
.code 7207 7303
.code 551 7304
.code 4647 7305
.code 2599 7306
.code 6695 7307
.code 1575 7308
.code 5671 7309
.code 3623 7310
.code 7719 7311
.code 295 7312
.code 4391 7313
.code 2343 7314
.code 6439 7315
.code 1319 7316
.code 5415 7317
.code 3367 7318
.code 7463 7319
.code 807 7320
.code 4903 7321
.code 2855 7322
.code 6951 7323
.code 1831 7324
.code 5927 7325
.code 3879 7326
.code 7975 7327
.code 167 7328
.code 4263 7329
.code 2215 7330
.code 6311 7331
.code 1191 7332
.code 5287 7333
.code 3239 7334
.code 7335 7335
.code 679 7336
.code 4775 7337
.code 2727 7338
.code 6823 7339
.code 1703 7340
.code 5799 7341
.code 3751 7342
.code 7847 7343
.code 423 7344
.code 4519 7345
.code 2471 7346
.code 6567 7347
.code 1447 7348
.code 5543 7349
.code 3495 7350
.code 7591 7351
.code 935 7352
.code 5031 7353
.code 2983 7354
.code 7079 7355
.code 1959 7356
.code 6055 7357
.code 4007 7358
.code 8103 7359
.code 103 7360
.code 4199 7361
.code 2151 7362
.code 6247 7363
.code 1127 7364
.code 5223 7365
.code 3175 7366
.code 7271 7367
.code 615 7368
.code 4711 7369
.code 2663 7370
.code 6759 7371
.code 1639 7372
.code 5735 7373
.code 3687 7374
.code 7783 7375
.code 359 7376
.code 4455 7377
.code 2407 7378
.code 6503 7379
.code 1383 7380
.code 5479 7381
.code 3431 7382
.code 7527 7383
.code 871 7384
.code 4967 7385
.code 2919 7386
.code 7015 7387
.code 1895 7388
.code 5991 7389
.code 3943 7390
.code 8039 7391
.code 231 7392
.code 4327 7393
.code 2279 7394
.code 6375 7395
.code 1255 7396
.code 5351 7397
.code 3303 7398
.code 7399 7399
.code 743 7400
.code 4839 7401
.code 2791 7402
.code 6887 7403
.code 1767 7404
.code 5863 7405
.code 3815 7406
.code 7911 7407
.code 487 7408
.code 4583 7409
.code 2535 7410
.code 6631 7411
.code 1511 7412
.code 5607 7413
.code 3559 7414
.code 7655 7415
.code 999 7416
.code 5095 7417
.code 3047 7418
.code 7143 7419
.code 2023 7420
.code 6119 7421
.code 4071 7422
.code 8167 7423
.code 23 7424
.code 4119 7425
.code 2071 7426
.code 6167 7427
.code 1047 7428
.code 5143 7429
.code 3095 7430
.code 7191 7431
.code 535 7432
.code 4631 7433
.code 2583 7434
.code 6679 7435
.code 1559 7436
.code 5655 7437
.code 3607 7438
.code 7703 7439
.code 279 7440
.code 4375 7441
.code 2327 7442
.code 6423 7443
.code 1303 7444
.code 5399 7445
.code 3351 7446
.code 7447 7447
.code 791 7448
.code 4887 7449
.code 2839 7450
.code 6935 7451
.code 1815 7452
.code 5911 7453
.code 3863 7454
.code 7959 7455
.code 151 7456
.code 4247 7457
.code 2199 7458
.code 6295 7459
.code 1175 7460
.code 5271 7461
.code 3223 7462
.code 7319 7463
.code 663 7464
.code 4759 7465
.code 2711 7466
.code 6807 7467
.code 1687 7468
.code 5783 7469
.code 3735 7470
.code 7831 7471
.code 407 7472
.code 4503 7473
.code 2455 7474
.code 6551 7475
.code 1431 7476
.code 5527 7477
.code 3479 7478
.code 7575 7479
.code 919 7480
.code 5015 7481
.code 2967 7482
.code 7063 7483
.code 1943 7484
.code 6039 7485
.code 3991 7486
.code 8087 7487
.code 87 7488
.code 4183 7489
.code 2135 7490
.code 6231 7491
.code 1111 7492
.code 5207 7493
.code 3159 7494
.code 7255 7495
.code 599 7496
.code 4695 7497
.code 2647 7498
.code 6743 7499
.code 1623 7500
.code 5719 7501
.code 3671 7502
.code 7767 7503
.code 343 7504
.code 4439 7505
.code 2391 7506
.code 6487 7507
.code 1367 7508
.code 5463 7509
.code 3415 7510
.code 7511 7511
.code 855 7512
.code 4951 7513
.code 2903 7514
.code 6999 7515
.code 1879 7516
.code 5975 7517
.code 3927 7518
.code 8023 7519
.code 215 7520
.code 4311 7521
.code 2263 7522
.code 6359 7523
.code 1239 7524
.code 5335 7525
.code 3287 7526
.code 7383 7527
.code 727 7528
.code 4823 7529
.code 2775 7530
.code 6871 7531
.code 1751 7532
.code 5847 7533
.code 3799 7534
.code 7895 7535
.code 471 7536
.code 4567 7537
.code 2519 7538
.code 6615 7539
.code 1495 7540
.code 5591 7541
.code 3543 7542
.code 7639 7543
.code 983 7544
.code 5079 7545
.code 3031 7546
.code 7127 7547
.code 2007 7548
.code 6103 7549
.code 4055 7550
.code 8151 7551
.code 55 7552
.code 4151 7553
.code 2103 7554
.code 6199 7555
.code 1079 7556
.code 5175 7557
.code 3127 7558
.code 7223 7559
.code 567 7560
.code 4663 7561
.code 2615 7562
.code 6711 7563
.code 1591 7564
.code 5687 7565
.code 3639 7566
.code 7735 7567
.code 311 7568
.code 4407 7569
.code 2359 7570
.code 6455 7571
.code 1335 7572
.code 5431 7573
.code 3383 7574
.code 7479 7575
.code 823 7576
.code 4919 7577
.code 2871 7578
.code 6967 7579
.code 1847 7580
.code 5943 7581
.code 3895 7582
.code 7991 7583
.code 183 7584
.code 4279 7585
.code 2231 7586
.code 6327 7587
.code 1207 7588
.code 5303 7589
.code 3255 7590
.code 7351 7591
.code 695 7592
.code 4791 7593
.code 2743 7594
.code 6839 7595
.code 1719 7596
.code 5815 7597
.code 3767 7598
.code 7863 7599
.code 439 7600
.code 4535 7601
.code 2487 7602
.code 6583 7603
.code 1463 7604
.code 5559 7605
.code 3511 7606
.code 7607 7607
.code 951 7608
.code 5047 7609
.code 2999 7610
.code 7095 7611
.code 1975 7612
.code 6071 7613
.code 4023 7614
.code 8119 7615
.code 119 7616
.code 4215 7617
.code 2167 7618
.code 6263 7619
.code 1143 7620
.code 5239 7621
.code 3191 7622
.code 7287 7623
.code 631 7624
.code 4727 7625
.code 2679 7626
.code 6775 7627
.code 1655 7628
.code 5751 7629
.code 3703 7630
.code 7799 7631
.code 375 7632
.code 4471 7633
.code 2423 7634
.code 6519 7635
.code 1399 7636
.code 5495 7637
.code 3447 7638
.code 7543 7639
.code 887 7640
.code 4983 7641
.code 2935 7642
.code 7031 7643
.code 1911 7644
.code 6007 7645
.code 3959 7646
.code 8055 7647
.code 247 7648
.code 4343 7649
.code 2295 7650
.code 6391 7651
.code 1271 7652
.code 5367 7653
.code 3319 7654
.code 7415 7655
.code 759 7656
.code 4855 7657
.code 2807 7658
.code 6903 7659
.code 1783 7660
.code 5879 7661
.code 3831 7662
.code 7927 7663
.code 503 7664
.code 4599 7665
.code 2551 7666
.code 6647 7667
.code 1527 7668
.code 5623 7669
.code 3575 7670
.code 7671 7671
.code 1015 7672
.code 5111 7673
.code 3063 7674
.code 7159 7675
.code 2039 7676
.code 6135 7677
.code 4087 7678
.code 8183 7679
.code 15 7680
.code 4111 7681
.code 2063 7682
.code 6159 7683
.code 1039 7684
.code 5135 7685
.code 3087 7686
.code 7183 7687
.code 527 7688
.code 4623 7689
.code 2575 7690
.code 6671 7691
.code 1551 7692
.code 5647 7693
.code 3599 7694
.code 7695 7695
.code 271 7696
.code 4367 7697
.code 2319 7698
.code 6415 7699
.code 1295 7700
.code 5391 7701
.code 3343 7702
.code 7439 7703
.code 783 7704
.code 4879 7705
.code 2831 7706
.code 6927 7707
.code 1807 7708
.code 5903 7709
.code 3855 7710
.code 7951 7711
.code 143 7712
.code 4239 7713
.code 2191 7714
.code 6287 7715
.code 1167 7716
.code 5263 7717
.code 3215 7718
.code 7311 7719
.code 655 7720
.code 4751 7721
.code 2703 7722
.code 6799 7723
.code 1679 7724
.code 5775 7725
.code 3727 7726
.code 7823 7727
.code 399 7728
.code 4495 7729
.code 2447 7730
.code 6543 7731
.code 1423 7732
.code 5519 7733
.code 3471 7734
.code 7567 7735
.code 911 7736
.code 5007 7737
.code 2959 7738
.code 7055 7739
.code 1935 7740
.code 6031 7741
.code 3983 7742
.code 8079 7743
.code 79 7744
.code 4175 7745
.code 2127 7746
.code 6223 7747
.code 1103 7748
.code 5199 7749
.code 3151 7750
.code 7247 7751
.code 591 7752
.code 4687 7753
.code 2639 7754
.code 6735 7755
.code 1615 7756
.code 5711 7757
.code 3663 7758
.code 7759 7759
.code 335 7760
.code 4431 7761
.code 2383 7762
.code 6479 7763
.code 1359 7764
.code 5455 7765
.code 3407 7766
.code 7503 7767
.code 847 7768
.code 4943 7769
.code 2895 7770
.code 6991 7771
.code 1871 7772
.code 5967 7773
.code 3919 7774
.code 8015 7775
.code 207 7776
.code 4303 7777
.code 2255 7778
.code 6351 7779
.code 1231 7780
.code 5327 7781
.code 3279 7782
.code 7375 7783
.code 719 7784
.code 4815 7785
.code 2767 7786
.code 6863 7787
.code 1743 7788
.code 5839 7789
.code 3791 7790
.code 7887 7791
.code 463 7792
.code 4559 7793
.code 2511 7794
.code 6607 7795
.code 1487 7796
.code 5583 7797
.code 3535 7798
.code 7631 7799
.code 975 7800
.code 5071 7801
.code 3023 7802
.code 7119 7803
.code 1999 7804
.code 6095 7805
.code 4047 7806
.code 8143 7807
.code 47 7808
.code 4143 7809
.code 2095 7810
.code 6191 7811
.code 1071 7812
.code 5167 7813
.code 3119 7814
.code 7215 7815
.code 559 7816
.code 4655 7817
.code 2607 7818
.code 6703 7819
.code 1583 7820
.code 5679 7821
.code 3631 7822
.code 7727 7823
.code 303 7824
.code 4399 7825
.code 2351 7826
.code 6447 7827
.code 1327 7828
.code 5423 7829
.code 3375 7830
.code 7471 7831
.code 815 7832
.code 4911 7833
.code 2863 7834
.code 6959 7835
.code 1839 7836
.code 5935 7837
.code 3887 7838
.code 7983 7839
.code 175 7840
.code 4271 7841
.code 2223 7842
.code 6319 7843
.code 1199 7844
.code 5295 7845
.code 3247 7846
.code 7343 7847
.code 687 7848
.code 4783 7849
.code 2735 7850
.code 6831 7851
.code 1711 7852
.code 5807 7853
.code 3759 7854
.code 7855 7855
.code 431 7856
.code 4527 7857
.code 2479 7858
.code 6575 7859
.code 1455 7860
.code 5551 7861
.code 3503 7862
.code 7599 7863
.code 943 7864
.code 5039 7865
.code 2991 7866
.code 7087 7867
.code 1967 7868
.code 6063 7869
.code 4015 7870
.code 8111 7871
.code 111 7872
.code 4207 7873
.code 2159 7874
.code 6255 7875
.code 1135 7876
.code 5231 7877
.code 3183 7878
.code 7279 7879
.code 623 7880
.code 4719 7881
.code 2671 7882
.code 6767 7883
.code 1647 7884
.code 5743 7885
.code 3695 7886
.code 7791 7887
.code 367 7888
.code 4463 7889
.code 2415 7890
.code 6511 7891
.code 1391 7892
.code 5487 7893
.code 3439 7894
.code 7535 7895
.code 879 7896
.code 4975 7897
.code 2927 7898
.code 7023 7899
.code 1903 7900
.code 5999 7901
.code 3951 7902
.code 8047 7903
.code 239 7904
.code 4335 7905
.code 2287 7906
.code 6383 7907
.code 1263 7908
.code 5359 7909
.code 3311 7910
.code 7407 7911
.code 751 7912
.code 4847 7913
.code 2799 7914
.code 6895 7915
.code 1775 7916
.code 5871 7917
.code 3823 7918
.code 7919 7919
.code 495 7920
.code 4591 7921
.code 2543 7922
.code 6639 7923
.code 1519 7924
.code 5615 7925
.code 3567 7926
.code 7663 7927
.code 1007 7928
.code 5103 7929
.code 3055 7930
.code 7151 7931
.code 2031 7932
.code 6127 7933
.code 4079 7934
.code 8175 7935
.code 31 7936
.code 4127 7937
.code 2079 7938
.code 6175 7939
.code 1055 7940
.code 5151 7941
.code 3103 7942
.code 7199 7943
.code 543 7944
.code 4639 7945
.code 2591 7946
.code 6687 7947
.code 1567 7948
.code 5663 7949
.code 3615 7950
.code 7711 7951
.code 287 7952
.code 4383 7953
.code 2335 7954
.code 6431 7955
.code 1311 7956
.code 5407 7957
.code 3359 7958
.code 7455 7959
.code 799 7960
.code 4895 7961
.code 2847 7962
.code 6943 7963
.code 1823 7964
.code 5919 7965
.code 3871 7966
.code 7967 7967
.code 159 7968
.code 4255 7969
.code 2207 7970
.code 6303 7971
.code 1183 7972
.code 5279 7973
.code 3231 7974
.code 7327 7975
.code 671 7976
.code 4767 7977
.code 2719 7978
.code 6815 7979
.code 1695 7980
.code 5791 7981
.code 3743 7982
.code 7839 7983
.code 415 7984
.code 4511 7985
.code 2463 7986
.code 6559 7987
.code 1439 7988
.code 5535 7989
.code 3487 7990
.code 7583 7991
.code 927 7992
.code 5023 7993
.code 2975 7994
.code 7071 7995
.code 1951 7996
.code 6047 7997
.code 3999 7998
.code 8095 7999
.code 95 8000
.code 4191 8001
.code 2143 8002
.code 6239 8003
.code 1119 8004
.code 5215 8005
.code 3167 8006
.code 7263 8007
.code 607 8008
.code 4703 8009
.code 2655 8010
.code 6751 8011
.code 1631 8012
.code 5727 8013
.code 3679 8014
.code 7775 8015
.code 351 8016
.code 4447 8017
.code 2399 8018
.code 6495 8019
.code 1375 8020
.code 5471 8021
.code 3423 8022
.code 7519 8023
.code 863 8024
.code 4959 8025
.code 2911 8026
.code 7007 8027
.code 1887 8028
.code 5983 8029
.code 3935 8030
.code 8031 8031
.code 223 8032
.code 4319 8033
.code 2271 8034
.code 6367 8035
.code 1247 8036
.code 5343 8037
.code 3295 8038
.code 7391 8039
.code 735 8040
.code 4831 8041
.code 2783 8042
.code 6879 8043
.code 1759 8044
.code 5855 8045
.code 3807 8046
.code 7903 8047
.code 479 8048
.code 4575 8049
.code 2527 8050
.code 6623 8051
.code 1503 8052
.code 5599 8053
.code 3551 8054
.code 7647 8055
.code 991 8056
.code 5087 8057
.code 3039 8058
.code 7135 8059
.code 2015 8060
.code 6111 8061
.code 4063 8062
.code 8159 8063
.code 63 8064
.code 4159 8065
.code 2111 8066
.code 6207 8067
.code 1087 8068
.code 5183 8069
.code 3135 8070
.code 7231 8071
.code 575 8072
.code 4671 8073
.code 2623 8074
.code 6719 8075
.code 1599 8076
.code 5695 8077
.code 3647 8078
.code 7743 8079
.code 319 8080
.code 4415 8081
.code 2367 8082
.code 6463 8083
.code 1343 8084
.code 5439 8085
.code 3391 8086
.code 7487 8087
.code 831 8088
.code 4927 8089
.code 2879 8090
.code 6975 8091
.code 1855 8092
.code 5951 8093
.code 3903 8094
.code 7999 8095
.code 191 8096
.code 4287 8097
.code 2239 8098
.code 6335 8099
.code 1215 8100
.code 5311 8101
.code 3263 8102
.code 7359 8103
.code 703 8104
.code 4799 8105
.code 2751 8106
.code 6847 8107
.code 1727 8108
.code 5823 8109
.code 3775 8110
.code 7871 8111
.code 447 8112
.code 4543 8113
.code 2495 8114
.code 6591 8115
.code 1471 8116
.code 5567 8117
.code 3519 8118
.code 7615 8119
.code 959 8120
.code 5055 8121
.code 3007 8122
.code 7103 8123
.code 1983 8124
.code 6079 8125
.code 4031 8126
.code 8127 8127
.code 127 8128
.code 4223 8129
.code 2175 8130
.code 6271 8131
.code 1151 8132
.code 5247 8133
.code 3199 8134
.code 7295 8135
.code 639 8136
.code 4735 8137
.code 2687 8138
.code 6783 8139
.code 1663 8140
.code 5759 8141
.code 3711 8142
.code 7807 8143
.code 383 8144
.code 4479 8145
.code 2431 8146
.code 6527 8147
.code 1407 8148
.code 5503 8149
.code 3455 8150
.code 7551 8151
.code 895 8152
.code 4991 8153
.code 2943 8154
.code 7039 8155
.code 1919 8156
.code 6015 8157
.code 3967 8158
.code 8063 8159
.code 255 8160
.code 4351 8161
.code 2303 8162
.code 6399 8163
.code 1279 8164
.code 5375 8165
.code 3327 8166
.code 7423 8167
.code 767 8168
.code 4863 8169
.code 2815 8170
.code 6911 8171
.code 1791 8172
.code 5887 8173
.code 3839 8174
.code 7935 8175
.code 511 8176
.code 4607 8177
.code 2559 8178
.code 6655 8179
.code 1535 8180
.code 5631 8181
.code 3583 8182
.code 7679 8183
.code 1023 8184
.code 5119 8185
.code 3071 8186
.code 7167 8187
.code 2047 8188
.code 6143 8189
.code 4095 8190
.code 8191 8191

; the code of every pixel
.pixels plane 256 256
| AAAAAGULAADKFgAALwIAAJQNAAD5GAAAXgQAAMMPAAAoGwAAjQYAAPIRAABXHQAAvAgAACEUAACGHwAA6woAAFAWAAC1AQAA
| Gg0AAH8YAADkAwAASQ8AAK4aAAATBgAAeBEAAN0cAABCCAAApxMAAAwfAABxCgAA1hUAADsBAACgDAAABRgAAGoDAADPDgAA
| NBoAAJkFAAD+EAAAYxwAAMgHAAAtEwAAkh4AAPcJAABcFQAAwQAAACYMAACLFwAA8AIAAFUOAAC6GQAAHwUAAIQQAADpGwAA
| TgcAALMSAAAYHgAAfQkAAOIUAABHAAAArAsAABEXAAB2AgAA2w0AAEAZAAClBAAAChAAAG8bAADUBgAAORIAAJ4dAAADCQAA
| aBQAAM0fAAAyCwAAlxYAAPwBAABhDQAAxhgAACsEAACQDwAA9RoAAFoGAAC/EQAAJB0AAIkIAADuEwAAUx8AALgKAAAdFgAA
| ggEAAOcMAABMGAAAsQMAABYPAAB7GgAA4AUAAEURAACqHAAADwgAAHQTAADZHgAAPgoAAKMVAAAIAQAAbQwAANIXAAA3AwAA
| nA4AAAEaAABmBQAAyxAAADAcAACVBwAA+hIAAF8eAADECQAAKRUAAI4AAADzCwAAWBcAAL0CAAAiDgAAhxkAAOwEAABREAAA
| thsAABsHAACAEgAA5R0AAEoJAACvFAAAFAAAAHkLAADeFgAAQwIAAKgNAAANGQAAcgQAANcPAAA8GwAAoQYAAAYSAABrHQAA
| 0AgAADUUAACaHwAA/woAAGQWAADJAQAALg0AAJMYAAD4AwAAXQ8AAMIaAAAnBgAAjBEAAPEcAABWCAAAuxMAACAfAACFCgAA
| 6hUAAE8BAAC0DAAAGRgAAH4DAADjDgAASBoAAK0FAAASEQAAdxwAANwHAABBEwAAph4AAAsKAABwFQAA1QAAADoMAACfFwAA
| BAMAAGkOAADOGQAAMwUAAJgQAAD9GwAAYgcAAMcSAAAsHgAAkQkAAPYUAABbAAAAwAsAACUXAACKAgAA7w0AAFQZAAC5BAAA
| HhAAAIMbAADoBgAATRIAALIdAAAXCQAAfBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAACRsAAG4GAADTEQAA
| OB0AAJ0IAAACFAAAZx8AAMwKAAAxFgAAlgEAAPsMAABgGAAAxQMAACoPAACPGgAA9AUAAFkRAAC+HAAAIwgAAIgTAADtHgAA
| UgoAALcVAAAcAQAAgQwAAOYXAABLAwAAsA4AABUaAAB6BQAA3xAAAEQcAACpBwAADhMAAHMeAADYCQAAPRUAAKIAAAAHDAAA
| bBcAANECAAA2DgAAmxkAAEURAACqHAAADwgAAHQTAADZHgAAPgoAAKMVAAAIAQAAbQwAANIXAAA3AwAAnA4AAAEaAABmBQAA
| yxAAADAcAACVBwAA+hIAAF8eAADECQAAKRUAAI4AAADzCwAAWBcAAL0CAAAiDgAAhxkAAOwEAABREAAAthsAABsHAACAEgAA
| 5R0AAEoJAACvFAAAFAAAAHkLAADeFgAAQwIAAKgNAAANGQAAcgQAANcPAAA8GwAAoQYAAAYSAABrHQAA0AgAADUUAACaHwAA
| /woAAGQWAADJAQAALg0AAJMYAAD4AwAAXQ8AAMIaAAAnBgAAjBEAAPEcAABWCAAAuxMAACAfAACFCgAA6hUAAE8BAAC0DAAA
| GRgAAH4DAADjDgAASBoAAK0FAAASEQAAdxwAANwHAABBEwAAph4AAAsKAABwFQAA1QAAADoMAACfFwAABAMAAGkOAADOGQAA
| MwUAAJgQAAD9GwAAYgcAAMcSAAAsHgAAkQkAAPYUAABbAAAAwAsAACUXAACKAgAA7w0AAFQZAAC5BAAAHhAAAIMbAADoBgAA
| TRIAALIdAAAXCQAAfBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAACRsAAG4GAADTEQAAOB0AAJ0IAAACFAAA
| Zx8AAMwKAAAxFgAAlgEAAPsMAABgGAAAxQMAACoPAACPGgAA9AUAAFkRAAC+HAAAIwgAAIgTAADtHgAAUgoAALcVAAAcAQAA
| gQwAAOYXAABLAwAAsA4AABUaAAB6BQAA3xAAAEQcAACpBwAADhMAAHMeAADYCQAAPRUAAKIAAAAHDAAAbBcAANECAAA2DgAA
| mxkAAAAFAABlEAAAyhsAAC8HAACUEgAA+R0AAF4JAADDFAAAKAAAAI0LAADyFgAAVwIAALwNAAAhGQAAhgQAAOsPAABQGwAA
| tQYAABoSAAB/HQAA5AgAAEkUAACuHwAAEwsAAHgWAADdAQAAQg0AAKcYAAAMBAAAcQ8AANYaAAA7BgAAoBEAAAUdAABqCAAA
| zxMAADQfAACZCgAA/hUAAGMBAADIDAAALRgAAJIDAAD3DgAAXBoAAMEFAAAmEQAAixwAAPAHAABVEwAAuh4AAB8KAACEFQAA
| 6QAAAE4MAACzFwAAGAMAAH0OAADiGQAARwUAAKwQAAARHAAAdgcAANsSAABAHgAApQkAAAoVAABvAAAA1AsAADkXAACeAgAA
| Aw4AAGgZAADNBAAAMhAAAJcbAAD8BgAAYRIAAMYdAAArCQAAkBQAAPUfAABaCwAAvxYAACQCAACJDQAA7hgAAFMEAAC4DwAA
| HRsAAIIGAADnEQAATB0AALEIAAAWFAAAex8AAOAKAACKAgAA7w0AAFQZAAC5BAAAHhAAAIMbAADoBgAATRIAALIdAAAXCQAA
| fBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAACRsAAG4GAADTEQAAOB0AAJ0IAAACFAAAZx8AAMwKAAAxFgAA
| lgEAAPsMAABgGAAAxQMAACoPAACPGgAA9AUAAFkRAAC+HAAAIwgAAIgTAADtHgAAUgoAALcVAAAcAQAAgQwAAOYXAABLAwAA
| sA4AABUaAAB6BQAA3xAAAEQcAACpBwAADhMAAHMeAADYCQAAPRUAAKIAAAAHDAAAbBcAANECAAA2DgAAmxkAAAAFAABlEAAA
| yhsAAC8HAACUEgAA+R0AAF4JAADDFAAAKAAAAI0LAADyFgAAVwIAALwNAAAhGQAAhgQAAOsPAABQGwAAtQYAABoSAAB/HQAA
| 5AgAAEkUAACuHwAAEwsAAHgWAADdAQAAQg0AAKcYAAAMBAAAcQ8AANYaAAA7BgAAoBEAAAUdAABqCAAAzxMAADQfAACZCgAA
| /hUAAGMBAADIDAAALRgAAJIDAAD3DgAAXBoAAMEFAAAmEQAAixwAAPAHAABVEwAAuh4AAB8KAACEFQAA6QAAAE4MAACzFwAA
| GAMAAH0OAADiGQAARwUAAKwQAAARHAAAdgcAANsSAABAHgAApQkAAAoVAABvAAAA1AsAADkXAACeAgAAAw4AAGgZAADNBAAA
| MhAAAJcbAAD8BgAAYRIAAMYdAAArCQAAkBQAAPUfAABaCwAAvxYAACQCAACJDQAA7hgAAFMEAAC4DwAAHRsAAIIGAADnEQAA
| TB0AALEIAAAWFAAAex8AAOAKAABFFgAAqgEAAA8NAAB0GAAA2QMAAD4PAACjGgAACAYAAG0RAADSHAAANwgAAJwTAAABHwAA
| ZgoAAMsVAAAwAQAAlQwAAPoXAABfAwAAxA4AACkaAACOBQAA8xAAAFgcAAC9BwAAIhMAAIceAADsCQAAURUAALYAAAAbDAAA
| gBcAAOUCAABKDgAArxkAABQFAAB5EAAA3hsAAEMHAACoEgAADR4AAHIJAADXFAAAPAAAAKELAAAGFwAAawIAANANAAA1GQAA
| mgQAAP8PAABkGwAAyQYAAC4SAACTHQAA+AgAAF0UAADCHwAAJwsAAIwWAADxAQAAVg0AALsYAAAgBAAAhQ8AAOoaAABPBgAA
| tBEAABkdAAB+CAAA4xMAAEgfAACtCgAAEhYAAHcBAADcDAAAQRgAAKYDAAALDwAAcBoAANUFAAA6EQAAnxwAAAQIAABpEwAA
| zh4AADMKAACYFQAA/QAAAGIMAADHFwAALAMAAJEOAAD2GQAAWwUAAMAQAAAlHAAAzxMAADQfAACZCgAA/hUAAGMBAADIDAAA
| LRgAAJIDAAD3DgAAXBoAAMEFAAAmEQAAixwAAPAHAABVEwAAuh4AAB8KAACEFQAA6QAAAE4MAACzFwAAGAMAAH0OAADiGQAA
| RwUAAKwQAAARHAAAdgcAANsSAABAHgAApQkAAAoVAABvAAAA1AsAADkXAACeAgAAAw4AAGgZAADNBAAAMhAAAJcbAAD8BgAA
| YRIAAMYdAAArCQAAkBQAAPUfAABaCwAAvxYAACQCAACJDQAA7hgAAFMEAAC4DwAAHRsAAIIGAADnEQAATB0AALEIAAAWFAAA
| ex8AAOAKAABFFgAAqgEAAA8NAAB0GAAA2QMAAD4PAACjGgAACAYAAG0RAADSHAAANwgAAJwTAAABHwAAZgoAAMsVAAAwAQAA
| lQwAAPoXAABfAwAAxA4AACkaAACOBQAA8xAAAFgcAAC9BwAAIhMAAIceAADsCQAAURUAALYAAAAbDAAAgBcAAOUCAABKDgAA
| rxkAABQFAAB5EAAA3hsAAEMHAACoEgAADR4AAHIJAADXFAAAPAAAAKELAAAGFwAAawIAANANAAA1GQAAmgQAAP8PAABkGwAA
| yQYAAC4SAACTHQAA+AgAAF0UAADCHwAAJwsAAIwWAADxAQAAVg0AALsYAAAgBAAAhQ8AAOoaAABPBgAAtBEAABkdAAB+CAAA
| 4xMAAEgfAACtCgAAEhYAAHcBAADcDAAAQRgAAKYDAAALDwAAcBoAANUFAAA6EQAAnxwAAAQIAABpEwAAzh4AADMKAACYFQAA
| /QAAAGIMAADHFwAALAMAAJEOAAD2GQAAWwUAAMAQAAAlHAAAigcAAO8SAABUHgAAuQkAAB4VAACDAAAA6AsAAE0XAACyAgAA
| Fw4AAHwZAADhBAAARhAAAKsbAAAQBwAAdRIAANodAAA/CQAApBQAAAkAAABuCwAA0xYAADgCAACdDQAAAhkAAGcEAADMDwAA
| MRsAAJYGAAD7EQAAYB0AAMUIAAAqFAAAjx8AAPQKAABZFgAAvgEAACMNAACIGAAA7QMAAFIPAAC3GgAAHAYAAIERAADmHAAA
| SwgAALATAAAVHwAAegoAAN8VAABEAQAAqQwAAA4YAABzAwAA2A4AAD0aAACiBQAABxEAAGwcAADRBwAANhMAAJseAAAACgAA
| ZRUAAMoAAAAvDAAAlBcAAPkCAABeDgAAwxkAACgFAACNEAAA8hsAAFcHAAC8EgAAIR4AAIYJAADrFAAAUAAAALULAAAaFwAA
| fwIAAOQNAABJGQAArgQAABMQAAB4GwAA3QYAAEISAACnHQAADAkAAHEUAADWHwAAOwsAAKAWAAAFAgAAag0AABQFAAB5EAAA
| 3hsAAEMHAACoEgAADR4AAHIJAADXFAAAPAAAAKELAAAGFwAAawIAANANAAA1GQAAmgQAAP8PAABkGwAAyQYAAC4SAACTHQAA
| +AgAAF0UAADCHwAAJwsAAIwWAADxAQAAVg0AALsYAAAgBAAAhQ8AAOoaAABPBgAAtBEAABkdAAB+CAAA4xMAAEgfAACtCgAA
| EhYAAHcBAADcDAAAQRgAAKYDAAALDwAAcBoAANUFAAA6EQAAnxwAAAQIAABpEwAAzh4AADMKAACYFQAA/QAAAGIMAADHFwAA
| LAMAAJEOAAD2GQAAWwUAAMAQAAAlHAAAigcAAO8SAABUHgAAuQkAAB4VAACDAAAA6AsAAE0XAACyAgAAFw4AAHwZAADhBAAA
| RhAAAKsbAAAQBwAAdRIAANodAAA/CQAApBQAAAkAAABuCwAA0xYAADgCAACdDQAAAhkAAGcEAADMDwAAMRsAAJYGAAD7EQAA
| YB0AAMUIAAAqFAAAjx8AAPQKAABZFgAAvgEAACMNAACIGAAA7QMAAFIPAAC3GgAAHAYAAIERAADmHAAASwgAALATAAAVHwAA
| egoAAN8VAABEAQAAqQwAAA4YAABzAwAA2A4AAD0aAACiBQAABxEAAGwcAADRBwAANhMAAJseAAAACgAAZRUAAMoAAAAvDAAA
| lBcAAPkCAABeDgAAwxkAACgFAACNEAAA8hsAAFcHAAC8EgAAIR4AAIYJAADrFAAAUAAAALULAAAaFwAAfwIAAOQNAABJGQAA
| rgQAABMQAAB4GwAA3QYAAEISAACnHQAADAkAAHEUAADWHwAAOwsAAKAWAAAFAgAAag0AAM8YAAA0BAAAmQ8AAP4aAABjBgAA
| yBEAAC0dAACSCAAA9xMAAFwfAADBCgAAJhYAAIsBAADwDAAAVRgAALoDAAAfDwAAhBoAAOkFAABOEQAAsxwAABgIAAB9EwAA
| 4h4AAEcKAACsFQAAEQEAAHYMAADbFwAAQAMAAKUOAAAKGgAAbwUAANQQAAA5HAAAngcAAAMTAABoHgAAzQkAADIVAACXAAAA
| /AsAAGEXAADGAgAAKw4AAJAZAAD1BAAAWhAAAL8bAAAkBwAAiRIAAO4dAABTCQAAuBQAAB0AAACCCwAA5xYAAEwCAACxDQAA
| FhkAAHsEAADgDwAARRsAAKoGAAAPEgAAdB0AANkIAAA+FAAAox8AAAgLAABtFgAA0gEAADcNAACcGAAAAQQAAGYPAADLGgAA
| MAYAAJURAAD6HAAAXwgAAMQTAAApHwAAjgoAAPMVAABYAQAAvQwAACIYAACHAwAA7A4AAFEaAAC2BQAAGxEAAIAcAADlBwAA
| ShMAAK8eAABZFgAAvgEAACMNAACIGAAA7QMAAFIPAAC3GgAAHAYAAIERAADmHAAASwgAALATAAAVHwAAegoAAN8VAABEAQAA
| qQwAAA4YAABzAwAA2A4AAD0aAACiBQAABxEAAGwcAADRBwAANhMAAJseAAAACgAAZRUAAMoAAAAvDAAAlBcAAPkCAABeDgAA
| wxkAACgFAACNEAAA8hsAAFcHAAC8EgAAIR4AAIYJAADrFAAAUAAAALULAAAaFwAAfwIAAOQNAABJGQAArgQAABMQAAB4GwAA
| 3QYAAEISAACnHQAADAkAAHEUAADWHwAAOwsAAKAWAAAFAgAAag0AAM8YAAA0BAAAmQ8AAP4aAABjBgAAyBEAAC0dAACSCAAA
| 9xMAAFwfAADBCgAAJhYAAIsBAADwDAAAVRgAALoDAAAfDwAAhBoAAOkFAABOEQAAsxwAABgIAAB9EwAA4h4AAEcKAACsFQAA
| EQEAAHYMAADbFwAAQAMAAKUOAAAKGgAAbwUAANQQAAA5HAAAngcAAAMTAABoHgAAzQkAADIVAACXAAAA/AsAAGEXAADGAgAA
| Kw4AAJAZAAD1BAAAWhAAAL8bAAAkBwAAiRIAAO4dAABTCQAAuBQAAB0AAACCCwAA5xYAAEwCAACxDQAAFhkAAHsEAADgDwAA
| RRsAAKoGAAAPEgAAdB0AANkIAAA+FAAAox8AAAgLAABtFgAA0gEAADcNAACcGAAAAQQAAGYPAADLGgAAMAYAAJURAAD6HAAA
| XwgAAMQTAAApHwAAjgoAAPMVAABYAQAAvQwAACIYAACHAwAA7A4AAFEaAAC2BQAAGxEAAIAcAADlBwAAShMAAK8eAAAUCgAA
| eRUAAN4AAABDDAAAqBcAAA0DAAByDgAA1xkAADwFAAChEAAABhwAAGsHAADQEgAANR4AAJoJAAD/FAAAZAAAAMkLAAAuFwAA
| kwIAAPgNAABdGQAAwgQAACcQAACMGwAA8QYAAFYSAAC7HQAAIAkAAIUUAADqHwAATwsAALQWAAAZAgAAfg0AAOMYAABIBAAA
| rQ8AABIbAAB3BgAA3BEAAEEdAACmCAAACxQAAHAfAADVCgAAOhYAAJ8BAAAEDQAAaRgAAM4DAAAzDwAAmBoAAP0FAABiEQAA
| xxwAACwIAACREwAA9h4AAFsKAADAFQAAJQEAAIoMAADvFwAAVAMAALkOAAAeGgAAgwUAAOgQAABNHAAAsgcAABcTAAB8HgAA
| 4QkAAEYVAACrAAAAEAwAAHUXAADaAgAAPw4AAKQZAAAJBQAAbhAAANMbAAA4BwAAnRIAAAIeAABnCQAAzBQAADEAAACWCwAA
| +xYAAGACAADFDQAAKhkAAI8EAAD0DwAAngcAAAMTAABoHgAAzQkAADIVAACXAAAA/AsAAGEXAADGAgAAKw4AAJAZAAD1BAAA
| WhAAAL8bAAAkBwAAiRIAAO4dAABTCQAAuBQAAB0AAACCCwAA5xYAAEwCAACxDQAAFhkAAHsEAADgDwAARRsAAKoGAAAPEgAA
| dB0AANkIAAA+FAAAox8AAAgLAABtFgAA0gEAADcNAACcGAAAAQQAAGYPAADLGgAAMAYAAJURAAD6HAAAXwgAAMQTAAApHwAA
| jgoAAPMVAABYAQAAvQwAACIYAACHAwAA7A4AAFEaAAC2BQAAGxEAAIAcAADlBwAAShMAAK8eAAAUCgAAeRUAAN4AAABDDAAA
| qBcAAA0DAAByDgAA1xkAADwFAAChEAAABhwAAGsHAADQEgAANR4AAJoJAAD/FAAAZAAAAMkLAAAuFwAAkwIAAPgNAABdGQAA
| wgQAACcQAACMGwAA8QYAAFYSAAC7HQAAIAkAAIUUAADqHwAATwsAALQWAAAZAgAAfg0AAOMYAABIBAAArQ8AABIbAAB3BgAA
| 3BEAAEEdAACmCAAACxQAAHAfAADVCgAAOhYAAJ8BAAAEDQAAaRgAAM4DAAAzDwAAmBoAAP0FAABiEQAAxxwAACwIAACREwAA
| 9h4AAFsKAADAFQAAJQEAAIoMAADvFwAAVAMAALkOAAAeGgAAgwUAAOgQAABNHAAAsgcAABcTAAB8HgAA4QkAAEYVAACrAAAA
| EAwAAHUXAADaAgAAPw4AAKQZAAAJBQAAbhAAANMbAAA4BwAAnRIAAAIeAABnCQAAzBQAADEAAACWCwAA+xYAAGACAADFDQAA
| KhkAAI8EAAD0DwAAWRsAAL4GAAAjEgAAiB0AAO0IAABSFAAAtx8AABwLAACBFgAA5gEAAEsNAACwGAAAFQQAAHoPAADfGgAA
| RAYAAKkRAAAOHQAAcwgAANgTAAA9HwAAogoAAAcWAABsAQAA0QwAADYYAACbAwAAAA8AAGUaAADKBQAALxEAAJQcAAD5BwAA
| XhMAAMMeAAAoCgAAjRUAAPIAAABXDAAAvBcAACEDAACGDgAA6xkAAFAFAAC1EAAAGhwAAH8HAADkEgAASR4AAK4JAAATFQAA
| eAAAAN0LAABCFwAApwIAAAwOAABxGQAA1gQAADsQAACgGwAABQcAAGoSAADPHQAANAkAAJkUAAD+HwAAYwsAAMgWAAAtAgAA
| kg0AAPcYAABcBAAAwQ8AACYbAACLBgAA8BEAAFUdAAC6CAAAHxQAAIQfAADpCgAAThYAALMBAAAYDQAAfRgAAOIDAABHDwAA
| rBoAABEGAAB2EQAA2xwAAEAIAAClEwAACh8AAG8KAADUFQAAOQEAAOMYAABIBAAArQ8AABIbAAB3BgAA3BEAAEEdAACmCAAA
| CxQAAHAfAADVCgAAOhYAAJ8BAAAEDQAAaRgAAM4DAAAzDwAAmBoAAP0FAABiEQAAxxwAACwIAACREwAA9h4AAFsKAADAFQAA
| JQEAAIoMAADvFwAAVAMAALkOAAAeGgAAgwUAAOgQAABNHAAAsgcAABcTAAB8HgAA4QkAAEYVAACrAAAAEAwAAHUXAADaAgAA
| Pw4AAKQZAAAJBQAAbhAAANMbAAA4BwAAnRIAAAIeAABnCQAAzBQAADEAAACWCwAA+xYAAGACAADFDQAAKhkAAI8EAAD0DwAA
| WRsAAL4GAAAjEgAAiB0AAO0IAABSFAAAtx8AABwLAACBFgAA5gEAAEsNAACwGAAAFQQAAHoPAADfGgAARAYAAKkRAAAOHQAA
| cwgAANgTAAA9HwAAogoAAAcWAABsAQAA0QwAADYYAACbAwAAAA8AAGUaAADKBQAALxEAAJQcAAD5BwAAXhMAAMMeAAAoCgAA
| jRUAAPIAAABXDAAAvBcAACEDAACGDgAA6xkAAFAFAAC1EAAAGhwAAH8HAADkEgAASR4AAK4JAAATFQAAeAAAAN0LAABCFwAA
| pwIAAAwOAABxGQAA1gQAADsQAACgGwAABQcAAGoSAADPHQAANAkAAJkUAAD+HwAAYwsAAMgWAAAtAgAAkg0AAPcYAABcBAAA
| wQ8AACYbAACLBgAA8BEAAFUdAAC6CAAAHxQAAIQfAADpCgAAThYAALMBAAAYDQAAfRgAAOIDAABHDwAArBoAABEGAAB2EQAA
| 2xwAAEAIAAClEwAACh8AAG8KAADUFQAAOQEAAJ4MAAADGAAAaAMAAM0OAAAyGgAAlwUAAPwQAABhHAAAxgcAACsTAACQHgAA
| 9QkAAFoVAAC/AAAAJAwAAIkXAADuAgAAUw4AALgZAAAdBQAAghAAAOcbAABMBwAAsRIAABYeAAB7CQAA4BQAAEUAAACqCwAA
| DxcAAHQCAADZDQAAPhkAAKMEAAAIEAAAbRsAANIGAAA3EgAAnB0AAAEJAABmFAAAyx8AADALAACVFgAA+gEAAF8NAADEGAAA
| KQQAAI4PAADzGgAAWAYAAL0RAAAiHQAAhwgAAOwTAABRHwAAtgoAABsWAACAAQAA5QwAAEoYAACvAwAAFA8AAHkaAADeBQAA
| QxEAAKgcAAANCAAAchMAANceAAA8CgAAoRUAAAYBAABrDAAA0BcAADUDAACaDgAA/xkAAGQFAADJEAAALhwAAJMHAAD4EgAA
| XR4AAMIJAAAnFQAAjAAAAPELAABWFwAAuwIAACAOAACFGQAA6gQAAE8QAAC0GwAAGQcAAH4SAAAoCgAAjRUAAPIAAABXDAAA
| vBcAACEDAACGDgAA6xkAAFAFAAC1EAAAGhwAAH8HAADkEgAASR4AAK4JAAATFQAAeAAAAN0LAABCFwAApwIAAAwOAABxGQAA
| 1gQAADsQAACgGwAABQcAAGoSAADPHQAANAkAAJkUAAD+HwAAYwsAAMgWAAAtAgAAkg0AAPcYAABcBAAAwQ8AACYbAACLBgAA
| 8BEAAFUdAAC6CAAAHxQAAIQfAADpCgAAThYAALMBAAAYDQAAfRgAAOIDAABHDwAArBoAABEGAAB2EQAA2xwAAEAIAAClEwAA
| Ch8AAG8KAADUFQAAOQEAAJ4MAAADGAAAaAMAAM0OAAAyGgAAlwUAAPwQAABhHAAAxgcAACsTAACQHgAA9QkAAFoVAAC/AAAA
| JAwAAIkXAADuAgAAUw4AALgZAAAdBQAAghAAAOcbAABMBwAAsRIAABYeAAB7CQAA4BQAAEUAAACqCwAADxcAAHQCAADZDQAA
| PhkAAKMEAAAIEAAAbRsAANIGAAA3EgAAnB0AAAEJAABmFAAAyx8AADALAACVFgAA+gEAAF8NAADEGAAAKQQAAI4PAADzGgAA
| WAYAAL0RAAAiHQAAhwgAAOwTAABRHwAAtgoAABsWAACAAQAA5QwAAEoYAACvAwAAFA8AAHkaAADeBQAAQxEAAKgcAAANCAAA
| chMAANceAAA8CgAAoRUAAAYBAABrDAAA0BcAADUDAACaDgAA/xkAAGQFAADJEAAALhwAAJMHAAD4EgAAXR4AAMIJAAAnFQAA
| jAAAAPELAABWFwAAuwIAACAOAACFGQAA6gQAAE8QAAC0GwAAGQcAAH4SAADjHQAASAkAAK0UAAASAAAAdwsAANwWAABBAgAA
| pg0AAAsZAABwBAAA1Q8AADobAACfBgAABBIAAGkdAADOCAAAMxQAAJgfAAD9CgAAYhYAAMcBAAAsDQAAkRgAAPYDAABbDwAA
| wBoAACUGAACKEQAA7xwAAFQIAAC5EwAAHh8AAIMKAADoFQAATQEAALIMAAAXGAAAfAMAAOEOAABGGgAAqwUAABARAAB1HAAA
| 2gcAAD8TAACkHgAACQoAAG4VAADTAAAAOAwAAJ0XAAACAwAAZw4AAMwZAAAxBQAAlhAAAPsbAABgBwAAxRIAACoeAACPCQAA
| 9BQAAFkAAAC+CwAAIxcAAIgCAADtDQAAUhkAALcEAAAcEAAAgRsAAOYGAABLEgAAsB0AABUJAAB6FAAA3x8AAEQLAACpFgAA
| DgIAAHMNAADYGAAAPQQAAKIPAAAHGwAAbAYAANERAAA2HQAAmwgAAAAUAABlHwAAygoAAC8WAACUAQAA+QwAAF4YAADDAwAA
| bRsAANIGAAA3EgAAnB0AAAEJAABmFAAAyx8AADALAACVFgAA+gEAAF8NAADEGAAAKQQAAI4PAADzGgAAWAYAAL0RAAAiHQAA
| hwgAAOwTAABRHwAAtgoAABsWAACAAQAA5QwAAEoYAACvAwAAFA8AAHkaAADeBQAAQxEAAKgcAAANCAAAchMAANceAAA8CgAA
| oRUAAAYBAABrDAAA0BcAADUDAACaDgAA/xkAAGQFAADJEAAALhwAAJMHAAD4EgAAXR4AAMIJAAAnFQAAjAAAAPELAABWFwAA
| uwIAACAOAACFGQAA6gQAAE8QAAC0GwAAGQcAAH4SAADjHQAASAkAAK0UAAASAAAAdwsAANwWAABBAgAApg0AAAsZAABwBAAA
| 1Q8AADobAACfBgAABBIAAGkdAADOCAAAMxQAAJgfAAD9CgAAYhYAAMcBAAAsDQAAkRgAAPYDAABbDwAAwBoAACUGAACKEQAA
| 7xwAAFQIAAC5EwAAHh8AAIMKAADoFQAATQEAALIMAAAXGAAAfAMAAOEOAABGGgAAqwUAABARAAB1HAAA2gcAAD8TAACkHgAA
| CQoAAG4VAADTAAAAOAwAAJ0XAAACAwAAZw4AAMwZAAAxBQAAlhAAAPsbAABgBwAAxRIAACoeAACPCQAA9BQAAFkAAAC+CwAA
| IxcAAIgCAADtDQAAUhkAALcEAAAcEAAAgRsAAOYGAABLEgAAsB0AABUJAAB6FAAA3x8AAEQLAACpFgAADgIAAHMNAADYGAAA
| PQQAAKIPAAAHGwAAbAYAANERAAA2HQAAmwgAAAAUAABlHwAAygoAAC8WAACUAQAA+QwAAF4YAADDAwAAKA8AAI0aAADyBQAA
| VxEAALwcAAAhCAAAhhMAAOseAABQCgAAtRUAABoBAAB/DAAA5BcAAEkDAACuDgAAExoAAHgFAADdEAAAQhwAAKcHAAAMEwAA
| cR4AANYJAAA7FQAAoAAAAAUMAABqFwAAzwIAADQOAACZGQAA/gQAAGMQAADIGwAALQcAAJISAAD3HQAAXAkAAMEUAAAmAAAA
| iwsAAPAWAABVAgAAug0AAB8ZAACEBAAA6Q8AAE4bAACzBgAAGBIAAH0dAADiCAAARxQAAKwfAAARCwAAdhYAANsBAABADQAA
| pRgAAAoEAABvDwAA1BoAADkGAACeEQAAAx0AAGgIAADNEwAAMh8AAJcKAAD8FQAAYQEAAMYMAAArGAAAkAMAAPUOAABaGgAA
| vwUAACQRAACJHAAA7gcAAFMTAAC4HgAAHQoAAIIVAADnAAAATAwAALEXAAAWAwAAew4AAOAZAABFBQAAqhAAAA8cAAB0BwAA
| 2RIAAD4eAACjCQAACBUAALIMAAAXGAAAfAMAAOEOAABGGgAAqwUAABARAAB1HAAA2gcAAD8TAACkHgAACQoAAG4VAADTAAAA
| OAwAAJ0XAAACAwAAZw4AAMwZAAAxBQAAlhAAAPsbAABgBwAAxRIAACoeAACPCQAA9BQAAFkAAAC+CwAAIxcAAIgCAADtDQAA
| UhkAALcEAAAcEAAAgRsAAOYGAABLEgAAsB0AABUJAAB6FAAA3x8AAEQLAACpFgAADgIAAHMNAADYGAAAPQQAAKIPAAAHGwAA
| bAYAANERAAA2HQAAmwgAAAAUAABlHwAAygoAAC8WAACUAQAA+QwAAF4YAADDAwAAKA8AAI0aAADyBQAAVxEAALwcAAAhCAAA
| hhMAAOseAABQCgAAtRUAABoBAAB/DAAA5BcAAEkDAACuDgAAExoAAHgFAADdEAAAQhwAAKcHAAAMEwAAcR4AANYJAAA7FQAA
| oAAAAAUMAABqFwAAzwIAADQOAACZGQAA/gQAAGMQAADIGwAALQcAAJISAAD3HQAAXAkAAMEUAAAmAAAAiwsAAPAWAABVAgAA
| ug0AAB8ZAACEBAAA6Q8AAE4bAACzBgAAGBIAAH0dAADiCAAARxQAAKwfAAARCwAAdhYAANsBAABADQAApRgAAAoEAABvDwAA
| 1BoAADkGAACeEQAAAx0AAGgIAADNEwAAMh8AAJcKAAD8FQAAYQEAAMYMAAArGAAAkAMAAPUOAABaGgAAvwUAACQRAACJHAAA
| 7gcAAFMTAAC4HgAAHQoAAIIVAADnAAAATAwAALEXAAAWAwAAew4AAOAZAABFBQAAqhAAAA8cAAB0BwAA2RIAAD4eAACjCQAA
| CBUAAG0AAADSCwAANxcAAJwCAAABDgAAZhkAAMsEAAAwEAAAlRsAAPoGAABfEgAAxB0AACkJAACOFAAA8x8AAFgLAAC9FgAA
| IgIAAIcNAADsGAAAUQQAALYPAAAbGwAAgAYAAOURAABKHQAArwgAABQUAAB5HwAA3goAAEMWAACoAQAADQ0AAHIYAADXAwAA
| PA8AAKEaAAAGBgAAaxEAANAcAAA1CAAAmhMAAP8eAABkCgAAyRUAAC4BAACTDAAA+BcAAF0DAADCDgAAJxoAAIwFAADxEAAA
| VhwAALsHAAAgEwAAhR4AAOoJAABPFQAAtAAAABkMAAB+FwAA4wIAAEgOAACtGQAAEgUAAHcQAADcGwAAQQcAAKYSAAALHgAA
| cAkAANUUAAA6AAAAnwsAAAQXAABpAgAAzg0AADMZAACYBAAA/Q8AAGIbAADHBgAALBIAAJEdAAD2CAAAWxQAAMAfAAAlCwAA
| ihYAAO8BAABUDQAAuRgAAB4EAACDDwAA6BoAAE0GAAD3HQAAXAkAAMEUAAAmAAAAiwsAAPAWAABVAgAAug0AAB8ZAACEBAAA
| 6Q8AAE4bAACzBgAAGBIAAH0dAADiCAAARxQAAKwfAAARCwAAdhYAANsBAABADQAApRgAAAoEAABvDwAA1BoAADkGAACeEQAA
| Ax0AAGgIAADNEwAAMh8AAJcKAAD8FQAAYQEAAMYMAAArGAAAkAMAAPUOAABaGgAAvwUAACQRAACJHAAA7gcAAFMTAAC4HgAA
| HQoAAIIVAADnAAAATAwAALEXAAAWAwAAew4AAOAZAABFBQAAqhAAAA8cAAB0BwAA2RIAAD4eAACjCQAACBUAAG0AAADSCwAA
| NxcAAJwCAAABDgAAZhkAAMsEAAAwEAAAlRsAAPoGAABfEgAAxB0AACkJAACOFAAA8x8AAFgLAAC9FgAAIgIAAIcNAADsGAAA
| UQQAALYPAAAbGwAAgAYAAOURAABKHQAArwgAABQUAAB5HwAA3goAAEMWAACoAQAADQ0AAHIYAADXAwAAPA8AAKEaAAAGBgAA
| axEAANAcAAA1CAAAmhMAAP8eAABkCgAAyRUAAC4BAACTDAAA+BcAAF0DAADCDgAAJxoAAIwFAADxEAAAVhwAALsHAAAgEwAA
| hR4AAOoJAABPFQAAtAAAABkMAAB+FwAA4wIAAEgOAACtGQAAEgUAAHcQAADcGwAAQQcAAKYSAAALHgAAcAkAANUUAAA6AAAA
| nwsAAAQXAABpAgAAzg0AADMZAACYBAAA/Q8AAGIbAADHBgAALBIAAJEdAAD2CAAAWxQAAMAfAAAlCwAAihYAAO8BAABUDQAA
| uRgAAB4EAACDDwAA6BoAAE0GAACyEQAAFx0AAHwIAADhEwAARh8AAKsKAAAQFgAAdQEAANoMAAA/GAAApAMAAAkPAABuGgAA
| 0wUAADgRAACdHAAAAggAAGcTAADMHgAAMQoAAJYVAAD7AAAAYAwAAMUXAAAqAwAAjw4AAPQZAABZBQAAvhAAACMcAACIBwAA
| 7RIAAFIeAAC3CQAAHBUAAIEAAADmCwAASxcAALACAAAVDgAAehkAAN8EAABEEAAAqRsAAA4HAABzEgAA2B0AAD0JAACiFAAA
| BwAAAGwLAADRFgAANgIAAJsNAAAAGQAAZQQAAMoPAAAvGwAAlAYAAPkRAABeHQAAwwgAACgUAACNHwAA8goAAFcWAAC8AQAA
| IQ0AAIYYAADrAwAAUA8AALUaAAAaBgAAfxEAAOQcAABJCAAArhMAABMfAAB4CgAA3RUAAEIBAACnDAAADBgAAHEDAADWDgAA
| OxoAAKAFAAAFEQAAahwAAM8HAAA0EwAAmR4AAP4JAABjFQAAyAAAAC0MAACSFwAAPA8AAKEaAAAGBgAAaxEAANAcAAA1CAAA
| mhMAAP8eAABkCgAAyRUAAC4BAACTDAAA+BcAAF0DAADCDgAAJxoAAIwFAADxEAAAVhwAALsHAAAgEwAAhR4AAOoJAABPFQAA
| tAAAABkMAAB+FwAA4wIAAEgOAACtGQAAEgUAAHcQAADcGwAAQQcAAKYSAAALHgAAcAkAANUUAAA6AAAAnwsAAAQXAABpAgAA
| zg0AADMZAACYBAAA/Q8AAGIbAADHBgAALBIAAJEdAAD2CAAAWxQAAMAfAAAlCwAAihYAAO8BAABUDQAAuRgAAB4EAACDDwAA
| 6BoAAE0GAACyEQAAFx0AAHwIAADhEwAARh8AAKsKAAAQFgAAdQEAANoMAAA/GAAApAMAAAkPAABuGgAA0wUAADgRAACdHAAA
| AggAAGcTAADMHgAAMQoAAJYVAAD7AAAAYAwAAMUXAAAqAwAAjw4AAPQZAABZBQAAvhAAACMcAACIBwAA7RIAAFIeAAC3CQAA
| HBUAAIEAAADmCwAASxcAALACAAAVDgAAehkAAN8EAABEEAAAqRsAAA4HAABzEgAA2B0AAD0JAACiFAAABwAAAGwLAADRFgAA
| NgIAAJsNAAAAGQAAZQQAAMoPAAAvGwAAlAYAAPkRAABeHQAAwwgAACgUAACNHwAA8goAAFcWAAC8AQAAIQ0AAIYYAADrAwAA
| UA8AALUaAAAaBgAAfxEAAOQcAABJCAAArhMAABMfAAB4CgAA3RUAAEIBAACnDAAADBgAAHEDAADWDgAAOxoAAKAFAAAFEQAA
| ahwAAM8HAAA0EwAAmR4AAP4JAABjFQAAyAAAAC0MAACSFwAA9wIAAFwOAADBGQAAJgUAAIsQAADwGwAAVQcAALoSAAAfHgAA
| hAkAAOkUAABOAAAAswsAABgXAAB9AgAA4g0AAEcZAACsBAAAERAAAHYbAADbBgAAQBIAAKUdAAAKCQAAbxQAANQfAAA5CwAA
| nhYAAAMCAABoDQAAzRgAADIEAACXDwAA/BoAAGEGAADGEQAAKx0AAJAIAAD1EwAAWh8AAL8KAAAkFgAAiQEAAO4MAABTGAAA
| uAMAAB0PAACCGgAA5wUAAEwRAACxHAAAFggAAHsTAADgHgAARQoAAKoVAAAPAQAAdAwAANkXAAA+AwAAow4AAAgaAABtBQAA
| 0hAAADccAACcBwAAARMAAGYeAADLCQAAMBUAAJUAAAD6CwAAXxcAAMQCAAApDgAAjhkAAPMEAABYEAAAvRsAACIHAACHEgAA
| 7B0AAFEJAAC2FAAAGwAAAIALAADlFgAASgIAAK8NAAAUGQAAeQQAAN4PAABDGwAAqAYAAA0SAAByHQAA1wgAAIEAAADmCwAA
| SxcAALACAAAVDgAAehkAAN8EAABEEAAAqRsAAA4HAABzEgAA2B0AAD0JAACiFAAABwAAAGwLAADRFgAANgIAAJsNAAAAGQAA
| ZQQAAMoPAAAvGwAAlAYAAPkRAABeHQAAwwgAACgUAACNHwAA8goAAFcWAAC8AQAAIQ0AAIYYAADrAwAAUA8AALUaAAAaBgAA
| fxEAAOQcAABJCAAArhMAABMfAAB4CgAA3RUAAEIBAACnDAAADBgAAHEDAADWDgAAOxoAAKAFAAAFEQAAahwAAM8HAAA0EwAA
| mR4AAP4JAABjFQAAyAAAAC0MAACSFwAA9wIAAFwOAADBGQAAJgUAAIsQAADwGwAAVQcAALoSAAAfHgAAhAkAAOkUAABOAAAA
| swsAABgXAAB9AgAA4g0AAEcZAACsBAAAERAAAHYbAADbBgAAQBIAAKUdAAAKCQAAbxQAANQfAAA5CwAAnhYAAAMCAABoDQAA
| zRgAADIEAACXDwAA/BoAAGEGAADGEQAAKx0AAJAIAAD1EwAAWh8AAL8KAAAkFgAAiQEAAO4MAABTGAAAuAMAAB0PAACCGgAA
| 5wUAAEwRAACxHAAAFggAAHsTAADgHgAARQoAAKoVAAAPAQAAdAwAANkXAAA+AwAAow4AAAgaAABtBQAA0hAAADccAACcBwAA
| ARMAAGYeAADLCQAAMBUAAJUAAAD6CwAAXxcAAMQCAAApDgAAjhkAAPMEAABYEAAAvRsAACIHAACHEgAA7B0AAFEJAAC2FAAA
| GwAAAIALAADlFgAASgIAAK8NAAAUGQAAeQQAAN4PAABDGwAAqAYAAA0SAAByHQAA1wgAADwUAAChHwAABgsAAGsWAADQAQAA
| NQ0AAJoYAAD/AwAAZA8AAMkaAAAuBgAAkxEAAPgcAABdCAAAwhMAACcfAACMCgAA8RUAAFYBAAC7DAAAIBgAAIUDAADqDgAA
| TxoAALQFAAAZEQAAfhwAAOMHAABIEwAArR4AABIKAAB3FQAA3AAAAEEMAACmFwAACwMAAHAOAADVGQAAOgUAAJ8QAAAEHAAA
| aQcAAM4SAAAzHgAAmAkAAP0UAABiAAAAxwsAACwXAACRAgAA9g0AAFsZAADABAAAJRAAAIobAADvBgAAVBIAALkdAAAeCQAA
| gxQAAOgfAABNCwAAshYAABcCAAB8DQAA4RgAAEYEAACrDwAAEBsAAHUGAADaEQAAPx0AAKQIAAAJFAAAbh8AANMKAAA4FgAA
| nQEAAAINAABnGAAAzAMAADEPAACWGgAA+wUAAGARAADFHAAAKggAAI8TAAD0HgAAWQoAAL4VAAAjAQAAiAwAAO0XAABSAwAA
| tw4AABwaAADGEQAAKx0AAJAIAAD1EwAAWh8AAL8KAAAkFgAAiQEAAO4MAABTGAAAuAMAAB0PAACCGgAA5wUAAEwRAACxHAAA
| FggAAHsTAADgHgAARQoAAKoVAAAPAQAAdAwAANkXAAA+AwAAow4AAAgaAABtBQAA0hAAADccAACcBwAAARMAAGYeAADLCQAA
| MBUAAJUAAAD6CwAAXxcAAMQCAAApDgAAjhkAAPMEAABYEAAAvRsAACIHAACHEgAA7B0AAFEJAAC2FAAAGwAAAIALAADlFgAA
| SgIAAK8NAAAUGQAAeQQAAN4PAABDGwAAqAYAAA0SAAByHQAA1wgAADwUAAChHwAABgsAAGsWAADQAQAANQ0AAJoYAAD/AwAA
| ZA8AAMkaAAAuBgAAkxEAAPgcAABdCAAAwhMAACcfAACMCgAA8RUAAFYBAAC7DAAAIBgAAIUDAADqDgAATxoAALQFAAAZEQAA
| fhwAAOMHAABIEwAArR4AABIKAAB3FQAA3AAAAEEMAACmFwAACwMAAHAOAADVGQAAOgUAAJ8QAAAEHAAAaQcAAM4SAAAzHgAA
| mAkAAP0UAABiAAAAxwsAACwXAACRAgAA9g0AAFsZAADABAAAJRAAAIobAADvBgAAVBIAALkdAAAeCQAAgxQAAOgfAABNCwAA
| shYAABcCAAB8DQAA4RgAAEYEAACrDwAAEBsAAHUGAADaEQAAPx0AAKQIAAAJFAAAbh8AANMKAAA4FgAAnQEAAAINAABnGAAA
| zAMAADEPAACWGgAA+wUAAGARAADFHAAAKggAAI8TAAD0HgAAWQoAAL4VAAAjAQAAiAwAAO0XAABSAwAAtw4AABwaAACBBQAA
| 5hAAAEscAACwBwAAFRMAAHoeAADfCQAARBUAAKkAAAAODAAAcxcAANgCAAA9DgAAohkAAAcFAABsEAAA0RsAADYHAACbEgAA
| AB4AAGUJAADKFAAALwAAAJQLAAD5FgAAXgIAAMMNAAAoGQAAjQQAAPIPAABXGwAAvAYAACESAACGHQAA6wgAAFAUAAC1HwAA
| GgsAAH8WAADkAQAASQ0AAK4YAAATBAAAeA8AAN0aAABCBgAApxEAAAwdAABxCAAA1hMAADsfAACgCgAABRYAAGoBAADPDAAA
| NBgAAJkDAAD+DgAAYxoAAMgFAAAtEQAAkhwAAPcHAABcEwAAwR4AACYKAACLFQAA8AAAAFUMAAC6FwAAHwMAAIQOAADpGQAA
| TgUAALMQAAAYHAAAfQcAAOISAABHHgAArAkAABEVAAB2AAAA2wsAAEAXAAClAgAACg4AAG8ZAADUBAAAORAAAJ4bAAADBwAA
| aBIAAM0dAAAyCQAAlxQAAPwfAABhCwAACwMAAHAOAADVGQAAOgUAAJ8QAAAEHAAAaQcAAM4SAAAzHgAAmAkAAP0UAABiAAAA
| xwsAACwXAACRAgAA9g0AAFsZAADABAAAJRAAAIobAADvBgAAVBIAALkdAAAeCQAAgxQAAOgfAABNCwAAshYAABcCAAB8DQAA
| 4RgAAEYEAACrDwAAEBsAAHUGAADaEQAAPx0AAKQIAAAJFAAAbh8AANMKAAA4FgAAnQEAAAINAABnGAAAzAMAADEPAACWGgAA
| +wUAAGARAADFHAAAKggAAI8TAAD0HgAAWQoAAL4VAAAjAQAAiAwAAO0XAABSAwAAtw4AABwaAACBBQAA5hAAAEscAACwBwAA
| FRMAAHoeAADfCQAARBUAAKkAAAAODAAAcxcAANgCAAA9DgAAohkAAAcFAABsEAAA0RsAADYHAACbEgAAAB4AAGUJAADKFAAA
| LwAAAJQLAAD5FgAAXgIAAMMNAAAoGQAAjQQAAPIPAABXGwAAvAYAACESAACGHQAA6wgAAFAUAAC1HwAAGgsAAH8WAADkAQAA
| SQ0AAK4YAAATBAAAeA8AAN0aAABCBgAApxEAAAwdAABxCAAA1hMAADsfAACgCgAABRYAAGoBAADPDAAANBgAAJkDAAD+DgAA
| YxoAAMgFAAAtEQAAkhwAAPcHAABcEwAAwR4AACYKAACLFQAA8AAAAFUMAAC6FwAAHwMAAIQOAADpGQAATgUAALMQAAAYHAAA
| fQcAAOISAABHHgAArAkAABEVAAB2AAAA2wsAAEAXAAClAgAACg4AAG8ZAADUBAAAORAAAJ4bAAADBwAAaBIAAM0dAAAyCQAA
| lxQAAPwfAABhCwAAxhYAACsCAACQDQAA9RgAAFoEAAC/DwAAJBsAAIkGAADuEQAAUx0AALgIAAAdFAAAgh8AAOcKAABMFgAA
| sQEAABYNAAB7GAAA4AMAAEUPAACqGgAADwYAAHQRAADZHAAAPggAAKMTAAAIHwAAbQoAANIVAAA3AQAAnAwAAAEYAABmAwAA
| yw4AADAaAACVBQAA+hAAAF8cAADEBwAAKRMAAI4eAADzCQAAWBUAAL0AAAAiDAAAhxcAAOwCAABRDgAAthkAABsFAACAEAAA
| 5RsAAEoHAACvEgAAFB4AAHkJAADeFAAAQwAAAKgLAAANFwAAcgIAANcNAAA8GQAAoQQAAAYQAABrGwAA0AYAADUSAACaHQAA
| /wgAAGQUAADJHwAALgsAAJMWAAD4AQAAXQ0AAMIYAAAnBAAAjA8AAPEaAABWBgAAuxEAACAdAACFCAAA6hMAAE8fAAC0CgAA
| GRYAAH4BAADjDAAASBgAAK0DAAASDwAAdxoAANwFAABBEQAAphwAAFAUAAC1HwAAGgsAAH8WAADkAQAASQ0AAK4YAAATBAAA
| eA8AAN0aAABCBgAApxEAAAwdAABxCAAA1hMAADsfAACgCgAABRYAAGoBAADPDAAANBgAAJkDAAD+DgAAYxoAAMgFAAAtEQAA
| khwAAPcHAABcEwAAwR4AACYKAACLFQAA8AAAAFUMAAC6FwAAHwMAAIQOAADpGQAATgUAALMQAAAYHAAAfQcAAOISAABHHgAA
| rAkAABEVAAB2AAAA2wsAAEAXAAClAgAACg4AAG8ZAADUBAAAORAAAJ4bAAADBwAAaBIAAM0dAAAyCQAAlxQAAPwfAABhCwAA
| xhYAACsCAACQDQAA9RgAAFoEAAC/DwAAJBsAAIkGAADuEQAAUx0AALgIAAAdFAAAgh8AAOcKAABMFgAAsQEAABYNAAB7GAAA
| 4AMAAEUPAACqGgAADwYAAHQRAADZHAAAPggAAKMTAAAIHwAAbQoAANIVAAA3AQAAnAwAAAEYAABmAwAAyw4AADAaAACVBQAA
| +hAAAF8cAADEBwAAKRMAAI4eAADzCQAAWBUAAL0AAAAiDAAAhxcAAOwCAABRDgAAthkAABsFAACAEAAA5RsAAEoHAACvEgAA
| FB4AAHkJAADeFAAAQwAAAKgLAAANFwAAcgIAANcNAAA8GQAAoQQAAAYQAABrGwAA0AYAADUSAACaHQAA/wgAAGQUAADJHwAA
| LgsAAJMWAAD4AQAAXQ0AAMIYAAAnBAAAjA8AAPEaAABWBgAAuxEAACAdAACFCAAA6hMAAE8fAAC0CgAAGRYAAH4BAADjDAAA
| SBgAAK0DAAASDwAAdxoAANwFAABBEQAAphwAAAsIAABwEwAA1R4AADoKAACfFQAABAEAAGkMAADOFwAAMwMAAJgOAAD9GQAA
| YgUAAMcQAAAsHAAAkQcAAPYSAABbHgAAwAkAACUVAACKAAAA7wsAAFQXAAC5AgAAHg4AAIMZAADoBAAATRAAALIbAAAXBwAA
| fBIAAOEdAABGCQAAqxQAABAAAAB1CwAA2hYAAD8CAACkDQAACRkAAG4EAADTDwAAOBsAAJ0GAAACEgAAZx0AAMwIAAAxFAAA
| lh8AAPsKAABgFgAAxQEAACoNAACPGAAA9AMAAFkPAAC+GgAAIwYAAIgRAADtHAAAUggAALcTAAAcHwAAgQoAAOYVAABLAQAA
| sAwAABUYAAB6AwAA3w4AAEQaAACpBQAADhEAAHMcAADYBwAAPRMAAKIeAAAHCgAAbBUAANEAAAA2DAAAmxcAAAADAABlDgAA
| yhkAAC8FAACUEAAA+RsAAF4HAADDEgAAKB4AAI0JAADyFAAAVwAAALwLAAAhFwAAhgIAAOsNAACVBQAA+hAAAF8cAADEBwAA
| KRMAAI4eAADzCQAAWBUAAL0AAAAiDAAAhxcAAOwCAABRDgAAthkAABsFAACAEAAA5RsAAEoHAACvEgAAFB4AAHkJAADeFAAA
| QwAAAKgLAAANFwAAcgIAANcNAAA8GQAAoQQAAAYQAABrGwAA0AYAADUSAACaHQAA/wgAAGQUAADJHwAALgsAAJMWAAD4AQAA
| XQ0AAMIYAAAnBAAAjA8AAPEaAABWBgAAuxEAACAdAACFCAAA6hMAAE8fAAC0CgAAGRYAAH4BAADjDAAASBgAAK0DAAASDwAA
| dxoAANwFAABBEQAAphwAAAsIAABwEwAA1R4AADoKAACfFQAABAEAAGkMAADOFwAAMwMAAJgOAAD9GQAAYgUAAMcQAAAsHAAA
| kQcAAPYSAABbHgAAwAkAACUVAACKAAAA7wsAAFQXAAC5AgAAHg4AAIMZAADoBAAATRAAALIbAAAXBwAAfBIAAOEdAABGCQAA
| qxQAABAAAAB1CwAA2hYAAD8CAACkDQAACRkAAG4EAADTDwAAOBsAAJ0GAAACEgAAZx0AAMwIAAAxFAAAlh8AAPsKAABgFgAA
| xQEAACoNAACPGAAA9AMAAFkPAAC+GgAAIwYAAIgRAADtHAAAUggAALcTAAAcHwAAgQoAAOYVAABLAQAAsAwAABUYAAB6AwAA
| 3w4AAEQaAACpBQAADhEAAHMcAADYBwAAPRMAAKIeAAAHCgAAbBUAANEAAAA2DAAAmxcAAAADAABlDgAAyhkAAC8FAACUEAAA
| +RsAAF4HAADDEgAAKB4AAI0JAADyFAAAVwAAALwLAAAhFwAAhgIAAOsNAABQGQAAtQQAABoQAAB/GwAA5AYAAEkSAACuHQAA
| EwkAAHgUAADdHwAAQgsAAKcWAAAMAgAAcQ0AANYYAAA7BAAAoA8AAAUbAABqBgAAzxEAADQdAACZCAAA/hMAAGMfAADICgAA
| LRYAAJIBAAD3DAAAXBgAAMEDAAAmDwAAixoAAPAFAABVEQAAuhwAAB8IAACEEwAA6R4AAE4KAACzFQAAGAEAAH0MAADiFwAA
| RwMAAKwOAAARGgAAdgUAANsQAABAHAAApQcAAAoTAABvHgAA1AkAADkVAACeAAAAAwwAAGgXAADNAgAAMg4AAJcZAAD8BAAA
| YRAAAMYbAAArBwAAkBIAAPUdAABaCQAAvxQAACQAAACJCwAA7hYAAFMCAAC4DQAAHRkAAIIEAADnDwAATBsAALEGAAAWEgAA
| ex0AAOAIAABFFAAAqh8AAA8LAAB0FgAA2QEAAD4NAACjGAAACAQAAG0PAADSGgAANwYAAJwRAAABHQAAZggAAMsTAAAwHwAA
| 2hYAAD8CAACkDQAACRkAAG4EAADTDwAAOBsAAJ0GAAACEgAAZx0AAMwIAAAxFAAAlh8AAPsKAABgFgAAxQEAACoNAACPGAAA
| 9AMAAFkPAAC+GgAAIwYAAIgRAADtHAAAUggAALcTAAAcHwAAgQoAAOYVAABLAQAAsAwAABUYAAB6AwAA3w4AAEQaAACpBQAA
| DhEAAHMcAADYBwAAPRMAAKIeAAAHCgAAbBUAANEAAAA2DAAAmxcAAAADAABlDgAAyhkAAC8FAACUEAAA+RsAAF4HAADDEgAA
| KB4AAI0JAADyFAAAVwAAALwLAAAhFwAAhgIAAOsNAABQGQAAtQQAABoQAAB/GwAA5AYAAEkSAACuHQAAEwkAAHgUAADdHwAA
| QgsAAKcWAAAMAgAAcQ0AANYYAAA7BAAAoA8AAAUbAABqBgAAzxEAADQdAACZCAAA/hMAAGMfAADICgAALRYAAJIBAAD3DAAA
| XBgAAMEDAAAmDwAAixoAAPAFAABVEQAAuhwAAB8IAACEEwAA6R4AAE4KAACzFQAAGAEAAH0MAADiFwAARwMAAKwOAAARGgAA
| dgUAANsQAABAHAAApQcAAAoTAABvHgAA1AkAADkVAACeAAAAAwwAAGgXAADNAgAAMg4AAJcZAAD8BAAAYRAAAMYbAAArBwAA
| kBIAAPUdAABaCQAAvxQAACQAAACJCwAA7hYAAFMCAAC4DQAAHRkAAIIEAADnDwAATBsAALEGAAAWEgAAex0AAOAIAABFFAAA
| qh8AAA8LAAB0FgAA2QEAAD4NAACjGAAACAQAAG0PAADSGgAANwYAAJwRAAABHQAAZggAAMsTAAAwHwAAlQoAAPoVAABfAQAA
| xAwAACkYAACOAwAA8w4AAFgaAAC9BQAAIhEAAIccAADsBwAAURMAALYeAAAbCgAAgBUAAOUAAABKDAAArxcAABQDAAB5DgAA
| 3hkAAEMFAACoEAAADRwAAHIHAADXEgAAPB4AAKEJAAAGFQAAawAAANALAAA1FwAAmgIAAP8NAABkGQAAyQQAAC4QAACTGwAA
| +AYAAF0SAADCHQAAJwkAAIwUAADxHwAAVgsAALsWAAAgAgAAhQ0AAOoYAABPBAAAtA8AABkbAAB+BgAA4xEAAEgdAACtCAAA
| EhQAAHcfAADcCgAAQRYAAKYBAAALDQAAcBgAANUDAAA6DwAAnxoAAAQGAABpEQAAzhwAADMIAACYEwAA/R4AAGIKAADHFQAA
| LAEAAJEMAAD2FwAAWwMAAMAOAAAlGgAAigUAAO8QAABUHAAAuQcAAB4TAACDHgAA6AkAAE0VAACyAAAAFwwAAHwXAADhAgAA
| Rg4AAKsZAAAQBQAAdRAAAB8IAACEEwAA6R4AAE4KAACzFQAAGAEAAH0MAADiFwAARwMAAKwOAAARGgAAdgUAANsQAABAHAAA
| pQcAAAoTAABvHgAA1AkAADkVAACeAAAAAwwAAGgXAADNAgAAMg4AAJcZAAD8BAAAYRAAAMYbAAArBwAAkBIAAPUdAABaCQAA
| vxQAACQAAACJCwAA7hYAAFMCAAC4DQAAHRkAAIIEAADnDwAATBsAALEGAAAWEgAAex0AAOAIAABFFAAAqh8AAA8LAAB0FgAA
| 2QEAAD4NAACjGAAACAQAAG0PAADSGgAANwYAAJwRAAABHQAAZggAAMsTAAAwHwAAlQoAAPoVAABfAQAAxAwAACkYAACOAwAA
| 8w4AAFgaAAC9BQAAIhEAAIccAADsBwAAURMAALYeAAAbCgAAgBUAAOUAAABKDAAArxcAABQDAAB5DgAA3hkAAEMFAACoEAAA
| DRwAAHIHAADXEgAAPB4AAKEJAAAGFQAAawAAANALAAA1FwAAmgIAAP8NAABkGQAAyQQAAC4QAACTGwAA+AYAAF0SAADCHQAA
| JwkAAIwUAADxHwAAVgsAALsWAAAgAgAAhQ0AAOoYAABPBAAAtA8AABkbAAB+BgAA4xEAAEgdAACtCAAAEhQAAHcfAADcCgAA
| QRYAAKYBAAALDQAAcBgAANUDAAA6DwAAnxoAAAQGAABpEQAAzhwAADMIAACYEwAA/R4AAGIKAADHFQAALAEAAJEMAAD2FwAA
| WwMAAMAOAAAlGgAAigUAAO8QAABUHAAAuQcAAB4TAACDHgAA6AkAAE0VAACyAAAAFwwAAHwXAADhAgAARg4AAKsZAAAQBQAA
| dRAAANobAAA/BwAApBIAAAkeAABuCQAA0xQAADgAAACdCwAAAhcAAGcCAADMDQAAMRkAAJYEAAD7DwAAYBsAAMUGAAAqEgAA
| jx0AAPQIAABZFAAAvh8AACMLAACIFgAA7QEAAFINAAC3GAAAHAQAAIEPAADmGgAASwYAALARAAAVHQAAeggAAN8TAABEHwAA
| qQoAAA4WAABzAQAA2AwAAD0YAACiAwAABw8AAGwaAADRBQAANhEAAJscAAAACAAAZRMAAMoeAAAvCgAAlBUAAPkAAABeDAAA
| wxcAACgDAACNDgAA8hkAAFcFAAC8EAAAIRwAAIYHAADrEgAAUB4AALUJAAAaFQAAfwAAAOQLAABJFwAArgIAABMOAAB4GQAA
| 3QQAAEIQAACnGwAADAcAAHESAADWHQAAOwkAAKAUAAAFAAAAagsAAM8WAAA0AgAAmQ0AAP4YAABjBAAAyA8AAC0bAACSBgAA
| 9xEAAFwdAADBCAAAJhQAAIsfAADwCgAAVRYAALoBAABkGQAAyQQAAC4QAACTGwAA+AYAAF0SAADCHQAAJwkAAIwUAADxHwAA
| VgsAALsWAAAgAgAAhQ0AAOoYAABPBAAAtA8AABkbAAB+BgAA4xEAAEgdAACtCAAAEhQAAHcfAADcCgAAQRYAAKYBAAALDQAA
| cBgAANUDAAA6DwAAnxoAAAQGAABpEQAAzhwAADMIAACYEwAA/R4AAGIKAADHFQAALAEAAJEMAAD2FwAAWwMAAMAOAAAlGgAA
| igUAAO8QAABUHAAAuQcAAB4TAACDHgAA6AkAAE0VAACyAAAAFwwAAHwXAADhAgAARg4AAKsZAAAQBQAAdRAAANobAAA/BwAA
| pBIAAAkeAABuCQAA0xQAADgAAACdCwAAAhcAAGcCAADMDQAAMRkAAJYEAAD7DwAAYBsAAMUGAAAqEgAAjx0AAPQIAABZFAAA
| vh8AACMLAACIFgAA7QEAAFINAAC3GAAAHAQAAIEPAADmGgAASwYAALARAAAVHQAAeggAAN8TAABEHwAAqQoAAA4WAABzAQAA
| 2AwAAD0YAACiAwAABw8AAGwaAADRBQAANhEAAJscAAAACAAAZRMAAMoeAAAvCgAAlBUAAPkAAABeDAAAwxcAACgDAACNDgAA
| 8hkAAFcFAAC8EAAAIRwAAIYHAADrEgAAUB4AALUJAAAaFQAAfwAAAOQLAABJFwAArgIAABMOAAB4GQAA3QQAAEIQAACnGwAA
| DAcAAHESAADWHQAAOwkAAKAUAAAFAAAAagsAAM8WAAA0AgAAmQ0AAP4YAABjBAAAyA8AAC0bAACSBgAA9xEAAFwdAADBCAAA
| JhQAAIsfAADwCgAAVRYAALoBAAAfDQAAhBgAAOkDAABODwAAsxoAABgGAAB9EQAA4hwAAEcIAACsEwAAER8AAHYKAADbFQAA
| QAEAAKUMAAAKGAAAbwMAANQOAAA5GgAAngUAAAMRAABoHAAAzQcAADITAACXHgAA/AkAAGEVAADGAAAAKwwAAJAXAAD1AgAA
| Wg4AAL8ZAAAkBQAAiRAAAO4bAABTBwAAuBIAAB0eAACCCQAA5xQAAEwAAACxCwAAFhcAAHsCAADgDQAARRkAAKoEAAAPEAAA
| dBsAANkGAAA+EgAAox0AAAgJAABtFAAA0h8AADcLAACcFgAAAQIAAGYNAADLGAAAMAQAAJUPAAD6GgAAXwYAAMQRAAApHQAA
| jggAAPMTAABYHwAAvQoAACIWAACHAQAA7AwAAFEYAAC2AwAAGw8AAIAaAADlBQAAShEAAK8cAAAUCAAAeRMAAN4eAABDCgAA
| qBUAAA0BAAByDAAA1xcAADwDAAChDgAABhoAAGsFAADQEAAANRwAAJoHAAD/EgAAqQoAAA4WAABzAQAA2AwAAD0YAACiAwAA
| Bw8AAGwaAADRBQAANhEAAJscAAAACAAAZRMAAMoeAAAvCgAAlBUAAPkAAABeDAAAwxcAACgDAACNDgAA8hkAAFcFAAC8EAAA
| IRwAAIYHAADrEgAAUB4AALUJAAAaFQAAfwAAAOQLAABJFwAArgIAABMOAAB4GQAA3QQAAEIQAACnGwAADAcAAHESAADWHQAA
| OwkAAKAUAAAFAAAAagsAAM8WAAA0AgAAmQ0AAP4YAABjBAAAyA8AAC0bAACSBgAA9xEAAFwdAADBCAAAJhQAAIsfAADwCgAA
| VRYAALoBAAAfDQAAhBgAAOkDAABODwAAsxoAABgGAAB9EQAA4hwAAEcIAACsEwAAER8AAHYKAADbFQAAQAEAAKUMAAAKGAAA
| bwMAANQOAAA5GgAAngUAAAMRAABoHAAAzQcAADITAACXHgAA/AkAAGEVAADGAAAAKwwAAJAXAAD1AgAAWg4AAL8ZAAAkBQAA
| iRAAAO4bAABTBwAAuBIAAB0eAACCCQAA5xQAAEwAAACxCwAAFhcAAHsCAADgDQAARRkAAKoEAAAPEAAAdBsAANkGAAA+EgAA
| ox0AAAgJAABtFAAA0h8AADcLAACcFgAAAQIAAGYNAADLGAAAMAQAAJUPAAD6GgAAXwYAAMQRAAApHQAAjggAAPMTAABYHwAA
| vQoAACIWAACHAQAA7AwAAFEYAAC2AwAAGw8AAIAaAADlBQAAShEAAK8cAAAUCAAAeRMAAN4eAABDCgAAqBUAAA0BAAByDAAA
| 1xcAADwDAAChDgAABhoAAGsFAADQEAAANRwAAJoHAAD/EgAAZB4AAMkJAAAuFQAAkwAAAPgLAABdFwAAwgIAACcOAACMGQAA
| 8QQAAFYQAAC7GwAAIAcAAIUSAADqHQAATwkAALQUAAAZAAAAfgsAAOMWAABIAgAArQ0AABIZAAB3BAAA3A8AAEEbAACmBgAA
| CxIAAHAdAADVCAAAOhQAAJ8fAAAECwAAaRYAAM4BAAAzDQAAmBgAAP0DAABiDwAAxxoAACwGAACREQAA9hwAAFsIAADAEwAA
| JR8AAIoKAADvFQAAVAEAALkMAAAeGAAAgwMAAOgOAABNGgAAsgUAABcRAAB8HAAA4QcAAEYTAACrHgAAEAoAAHUVAADaAAAA
| PwwAAKQXAAAJAwAAbg4AANMZAAA4BQAAnRAAAAIcAABnBwAAzBIAADEeAACWCQAA+xQAAGAAAADFCwAAKhcAAI8CAAD0DQAA
| WRkAAL4EAAAjEAAAiBsAAO0GAABSEgAAtx0AABwJAACBFAAA5h8AAEsLAACwFgAAFQIAAHoNAADfGAAARAQAAO4bAABTBwAA
| uBIAAB0eAACCCQAA5xQAAEwAAACxCwAAFhcAAHsCAADgDQAARRkAAKoEAAAPEAAAdBsAANkGAAA+EgAAox0AAAgJAABtFAAA
| 0h8AADcLAACcFgAAAQIAAGYNAADLGAAAMAQAAJUPAAD6GgAAXwYAAMQRAAApHQAAjggAAPMTAABYHwAAvQoAACIWAACHAQAA
| 7AwAAFEYAAC2AwAAGw8AAIAaAADlBQAAShEAAK8cAAAUCAAAeRMAAN4eAABDCgAAqBUAAA0BAAByDAAA1xcAADwDAAChDgAA
| BhoAAGsFAADQEAAANRwAAJoHAAD/EgAAZB4AAMkJAAAuFQAAkwAAAPgLAABdFwAAwgIAACcOAACMGQAA8QQAAFYQAAC7GwAA
| IAcAAIUSAADqHQAATwkAALQUAAAZAAAAfgsAAOMWAABIAgAArQ0AABIZAAB3BAAA3A8AAEEbAACmBgAACxIAAHAdAADVCAAA
| OhQAAJ8fAAAECwAAaRYAAM4BAAAzDQAAmBgAAP0DAABiDwAAxxoAACwGAACREQAA9hwAAFsIAADAEwAAJR8AAIoKAADvFQAA
| VAEAALkMAAAeGAAAgwMAAOgOAABNGgAAsgUAABcRAAB8HAAA4QcAAEYTAACrHgAAEAoAAHUVAADaAAAAPwwAAKQXAAAJAwAA
| bg4AANMZAAA4BQAAnRAAAAIcAABnBwAAzBIAADEeAACWCQAA+xQAAGAAAADFCwAAKhcAAI8CAAD0DQAAWRkAAL4EAAAjEAAA
| iBsAAO0GAABSEgAAtx0AABwJAACBFAAA5h8AAEsLAACwFgAAFQIAAHoNAADfGAAARAQAAKkPAAAOGwAAcwYAANgRAAA9HQAA
| oggAAAcUAABsHwAA0QoAADYWAACbAQAAAA0AAGUYAADKAwAALw8AAJQaAAD5BQAAXhEAAMMcAAAoCAAAjRMAAPIeAABXCgAA
| vBUAACEBAACGDAAA6xcAAFADAAC1DgAAGhoAAH8FAADkEAAASRwAAK4HAAATEwAAeB4AAN0JAABCFQAApwAAAAwMAABxFwAA
| 1gIAADsOAACgGQAABQUAAGoQAADPGwAANAcAAJkSAAD+HQAAYwkAAMgUAAAtAAAAkgsAAPcWAABcAgAAwQ0AACYZAACLBAAA
| 8A8AAFUbAAC6BgAAHxIAAIQdAADpCAAAThQAALMfAAAYCwAAfRYAAOIBAABHDQAArBgAABEEAAB2DwAA2xoAAEAGAAClEQAA
| Ch0AAG8IAADUEwAAOR8AAJ4KAAADFgAAaAEAAM0MAAAyGAAAlwMAAPwOAABhGgAAxgUAACsRAACQHAAA9QcAAFoTAAC/HgAA
| JAoAAIkVAAAzDQAAmBgAAP0DAABiDwAAxxoAACwGAACREQAA9hwAAFsIAADAEwAAJR8AAIoKAADvFQAAVAEAALkMAAAeGAAA
| gwMAAOgOAABNGgAAsgUAABcRAAB8HAAA4QcAAEYTAACrHgAAEAoAAHUVAADaAAAAPwwAAKQXAAAJAwAAbg4AANMZAAA4BQAA
| nRAAAAIcAABnBwAAzBIAADEeAACWCQAA+xQAAGAAAADFCwAAKhcAAI8CAAD0DQAAWRkAAL4EAAAjEAAAiBsAAO0GAABSEgAA
| tx0AABwJAACBFAAA5h8AAEsLAACwFgAAFQIAAHoNAADfGAAARAQAAKkPAAAOGwAAcwYAANgRAAA9HQAAoggAAAcUAABsHwAA
| 0QoAADYWAACbAQAAAA0AAGUYAADKAwAALw8AAJQaAAD5BQAAXhEAAMMcAAAoCAAAjRMAAPIeAABXCgAAvBUAACEBAACGDAAA
| 6xcAAFADAAC1DgAAGhoAAH8FAADkEAAASRwAAK4HAAATEwAAeB4AAN0JAABCFQAApwAAAAwMAABxFwAA1gIAADsOAACgGQAA
| BQUAAGoQAADPGwAANAcAAJkSAAD+HQAAYwkAAMgUAAAtAAAAkgsAAPcWAABcAgAAwQ0AACYZAACLBAAA8A8AAFUbAAC6BgAA
| HxIAAIQdAADpCAAAThQAALMfAAAYCwAAfRYAAOIBAABHDQAArBgAABEEAAB2DwAA2xoAAEAGAAClEQAACh0AAG8IAADUEwAA
| OR8AAJ4KAAADFgAAaAEAAM0MAAAyGAAAlwMAAPwOAABhGgAAxgUAACsRAACQHAAA9QcAAFoTAAC/HgAAJAoAAIkVAADuAAAA
| UwwAALgXAAAdAwAAgg4AAOcZAABMBQAAsRAAABYcAAB7BwAA4BIAAEUeAACqCQAADxUAAHQAAADZCwAAPhcAAKMCAAAIDgAA
| bRkAANIEAAA3EAAAnBsAAAEHAABmEgAAyx0AADAJAACVFAAA+h8AAF8LAADEFgAAKQIAAI4NAADzGAAAWAQAAL0PAAAiGwAA
| hwYAAOwRAABRHQAAtggAABsUAACAHwAA5QoAAEoWAACvAQAAFA0AAHkYAADeAwAAQw8AAKgaAAANBgAAchEAANccAAA8CAAA
| oRMAAAYfAABrCgAA0BUAADUBAACaDAAA/xcAAGQDAADJDgAALhoAAJMFAAD4EAAAXRwAAMIHAAAnEwAAjB4AAPEJAABWFQAA
| uwAAACAMAACFFwAA6gIAAE8OAAC0GQAAGQUAAH4QAADjGwAASAcAAK0SAAASHgAAdwkAANwUAABBAAAApgsAAAsXAABwAgAA
| 1Q0AADoZAACfBAAABBAAAGkbAADOBgAAeB4AAN0JAABCFQAApwAAAAwMAABxFwAA1gIAADsOAACgGQAABQUAAGoQAADPGwAA
| NAcAAJkSAAD+HQAAYwkAAMgUAAAtAAAAkgsAAPcWAABcAgAAwQ0AACYZAACLBAAA8A8AAFUbAAC6BgAAHxIAAIQdAADpCAAA
| ThQAALMfAAAYCwAAfRYAAOIBAABHDQAArBgAABEEAAB2DwAA2xoAAEAGAAClEQAACh0AAG8IAADUEwAAOR8AAJ4KAAADFgAA
| aAEAAM0MAAAyGAAAlwMAAPwOAABhGgAAxgUAACsRAACQHAAA9QcAAFoTAAC/HgAAJAoAAIkVAADuAAAAUwwAALgXAAAdAwAA
| gg4AAOcZAABMBQAAsRAAABYcAAB7BwAA4BIAAEUeAACqCQAADxUAAHQAAADZCwAAPhcAAKMCAAAIDgAAbRkAANIEAAA3EAAA
| nBsAAAEHAABmEgAAyx0AADAJAACVFAAA+h8AAF8LAADEFgAAKQIAAI4NAADzGAAAWAQAAL0PAAAiGwAAhwYAAOwRAABRHQAA
| tggAABsUAACAHwAA5QoAAEoWAACvAQAAFA0AAHkYAADeAwAAQw8AAKgaAAANBgAAchEAANccAAA8CAAAoRMAAAYfAABrCgAA
| 0BUAADUBAACaDAAA/xcAAGQDAADJDgAALhoAAJMFAAD4EAAAXRwAAMIHAAAnEwAAjB4AAPEJAABWFQAAuwAAACAMAACFFwAA
| 6gIAAE8OAAC0GQAAGQUAAH4QAADjGwAASAcAAK0SAAASHgAAdwkAANwUAABBAAAApgsAAAsXAABwAgAA1Q0AADoZAACfBAAA
| BBAAAGkbAADOBgAAMxIAAJgdAAD9CAAAYhQAAMcfAAAsCwAAkRYAAPYBAABbDQAAwBgAACUEAACKDwAA7xoAAFQGAAC5EQAA
| Hh0AAIMIAADoEwAATR8AALIKAAAXFgAAfAEAAOEMAABGGAAAqwMAABAPAAB1GgAA2gUAAD8RAACkHAAACQgAAG4TAADTHgAA
| OAoAAJ0VAAACAQAAZwwAAMwXAAAxAwAAlg4AAPsZAABgBQAAxRAAACocAACPBwAA9BIAAFkeAAC+CQAAIxUAAIgAAADtCwAA
| UhcAALcCAAAcDgAAgRkAAOYEAABLEAAAsBsAABUHAAB6EgAA3x0AAEQJAACpFAAADgAAAHMLAADYFgAAPQIAAKINAAAHGQAA
| bAQAANEPAAA2GwAAmwYAAAASAABlHQAAyggAAC8UAACUHwAA+QoAAF4WAADDAQAAKA0AAI0YAADyAwAAVw8AALwaAAAhBgAA
| hhEAAOscAABQCAAAtRMAABofAAB/CgAA5BUAAEkBAACuDAAAExgAAL0PAAAiGwAAhwYAAOwRAABRHQAAtggAABsUAACAHwAA
| 5QoAAEoWAACvAQAAFA0AAHkYAADeAwAAQw8AAKgaAAANBgAAchEAANccAAA8CAAAoRMAAAYfAABrCgAA0BUAADUBAACaDAAA
| /xcAAGQDAADJDgAALhoAAJMFAAD4EAAAXRwAAMIHAAAnEwAAjB4AAPEJAABWFQAAuwAAACAMAACFFwAA6gIAAE8OAAC0GQAA
| GQUAAH4QAADjGwAASAcAAK0SAAASHgAAdwkAANwUAABBAAAApgsAAAsXAABwAgAA1Q0AADoZAACfBAAABBAAAGkbAADOBgAA
| MxIAAJgdAAD9CAAAYhQAAMcfAAAsCwAAkRYAAPYBAABbDQAAwBgAACUEAACKDwAA7xoAAFQGAAC5EQAAHh0AAIMIAADoEwAA
| TR8AALIKAAAXFgAAfAEAAOEMAABGGAAAqwMAABAPAAB1GgAA2gUAAD8RAACkHAAACQgAAG4TAADTHgAAOAoAAJ0VAAACAQAA
| ZwwAAMwXAAAxAwAAlg4AAPsZAABgBQAAxRAAACocAACPBwAA9BIAAFkeAAC+CQAAIxUAAIgAAADtCwAAUhcAALcCAAAcDgAA
| gRkAAOYEAABLEAAAsBsAABUHAAB6EgAA3x0AAEQJAACpFAAADgAAAHMLAADYFgAAPQIAAKINAAAHGQAAbAQAANEPAAA2GwAA
| mwYAAAASAABlHQAAyggAAC8UAACUHwAA+QoAAF4WAADDAQAAKA0AAI0YAADyAwAAVw8AALwaAAAhBgAAhhEAAOscAABQCAAA
| tRMAABofAAB/CgAA5BUAAEkBAACuDAAAExgAAHgDAADdDgAAQhoAAKcFAAAMEQAAcRwAANYHAAA7EwAAoB4AAAUKAABqFQAA
| zwAAADQMAACZFwAA/gIAAGMOAADIGQAALQUAAJIQAAD3GwAAXAcAAMESAAAmHgAAiwkAAPAUAABVAAAAugsAAB8XAACEAgAA
| 6Q0AAE4ZAACzBAAAGBAAAH0bAADiBgAARxIAAKwdAAARCQAAdhQAANsfAABACwAApRYAAAoCAABvDQAA1BgAADkEAACeDwAA
| AxsAAGgGAADNEQAAMh0AAJcIAAD8EwAAYR8AAMYKAAArFgAAkAEAAPUMAABaGAAAvwMAACQPAACJGgAA7gUAAFMRAAC4HAAA
| HQgAAIITAADnHgAATAoAALEVAAAWAQAAewwAAOAXAABFAwAAqg4AAA8aAAB0BQAA2RAAAD4cAACjBwAACBMAAG0eAADSCQAA
| NxUAAJwAAAABDAAAZhcAAMsCAAAwDgAAlRkAAPoEAABfEAAAxBsAACkHAACOEgAA8x0AAFgJAAACAQAAZwwAAMwXAAAxAwAA
| lg4AAPsZAABgBQAAxRAAACocAACPBwAA9BIAAFkeAAC+CQAAIxUAAIgAAADtCwAAUhcAALcCAAAcDgAAgRkAAOYEAABLEAAA
| sBsAABUHAAB6EgAA3x0AAEQJAACpFAAADgAAAHMLAADYFgAAPQIAAKINAAAHGQAAbAQAANEPAAA2GwAAmwYAAAASAABlHQAA
| yggAAC8UAACUHwAA+QoAAF4WAADDAQAAKA0AAI0YAADyAwAAVw8AALwaAAAhBgAAhhEAAOscAABQCAAAtRMAABofAAB/CgAA
| 5BUAAEkBAACuDAAAExgAAHgDAADdDgAAQhoAAKcFAAAMEQAAcRwAANYHAAA7EwAAoB4AAAUKAABqFQAAzwAAADQMAACZFwAA
| /gIAAGMOAADIGQAALQUAAJIQAAD3GwAAXAcAAMESAAAmHgAAiwkAAPAUAABVAAAAugsAAB8XAACEAgAA6Q0AAE4ZAACzBAAA
| GBAAAH0bAADiBgAARxIAAKwdAAARCQAAdhQAANsfAABACwAApRYAAAoCAABvDQAA1BgAADkEAACeDwAAAxsAAGgGAADNEQAA
| Mh0AAJcIAAD8EwAAYR8AAMYKAAArFgAAkAEAAPUMAABaGAAAvwMAACQPAACJGgAA7gUAAFMRAAC4HAAAHQgAAIITAADnHgAA
| TAoAALEVAAAWAQAAewwAAOAXAABFAwAAqg4AAA8aAAB0BQAA2RAAAD4cAACjBwAACBMAAG0eAADSCQAANxUAAJwAAAABDAAA
| ZhcAAMsCAAAwDgAAlRkAAPoEAABfEAAAxBsAACkHAACOEgAA8x0AAFgJAAC9FAAAIgAAAIcLAADsFgAAUQIAALYNAAAbGQAA
| gAQAAOUPAABKGwAArwYAABQSAAB5HQAA3ggAAEMUAACoHwAADQsAAHIWAADXAQAAPA0AAKEYAAAGBAAAaw8AANAaAAA1BgAA
| mhEAAP8cAABkCAAAyRMAAC4fAACTCgAA+BUAAF0BAADCDAAAJxgAAIwDAADxDgAAVhoAALsFAAAgEQAAhRwAAOoHAABPEwAA
| tB4AABkKAAB+FQAA4wAAAEgMAACtFwAAEgMAAHcOAADcGQAAQQUAAKYQAAALHAAAcAcAANUSAAA6HgAAnwkAAAQVAABpAAAA
| zgsAADMXAACYAgAA/Q0AAGIZAADHBAAALBAAAJEbAAD2BgAAWxIAAMAdAAAlCQAAihQAAO8fAABUCwAAuRYAAB4CAACDDQAA
| 6BgAAE0EAACyDwAAFxsAAHwGAADhEQAARh0AAKsIAAAQFAAAdR8AANoKAAA/FgAApAEAAAkNAABuGAAA0wMAADgPAACdGgAA
| RxIAAKwdAAARCQAAdhQAANsfAABACwAApRYAAAoCAABvDQAA1BgAADkEAACeDwAAAxsAAGgGAADNEQAAMh0AAJcIAAD8EwAA
| YR8AAMYKAAArFgAAkAEAAPUMAABaGAAAvwMAACQPAACJGgAA7gUAAFMRAAC4HAAAHQgAAIITAADnHgAATAoAALEVAAAWAQAA
| ewwAAOAXAABFAwAAqg4AAA8aAAB0BQAA2RAAAD4cAACjBwAACBMAAG0eAADSCQAANxUAAJwAAAABDAAAZhcAAMsCAAAwDgAA
| lRkAAPoEAABfEAAAxBsAACkHAACOEgAA8x0AAFgJAAC9FAAAIgAAAIcLAADsFgAAUQIAALYNAAAbGQAAgAQAAOUPAABKGwAA
| rwYAABQSAAB5HQAA3ggAAEMUAACoHwAADQsAAHIWAADXAQAAPA0AAKEYAAAGBAAAaw8AANAaAAA1BgAAmhEAAP8cAABkCAAA
| yRMAAC4fAACTCgAA+BUAAF0BAADCDAAAJxgAAIwDAADxDgAAVhoAALsFAAAgEQAAhRwAAOoHAABPEwAAtB4AABkKAAB+FQAA
| 4wAAAEgMAACtFwAAEgMAAHcOAADcGQAAQQUAAKYQAAALHAAAcAcAANUSAAA6HgAAnwkAAAQVAABpAAAAzgsAADMXAACYAgAA
| /Q0AAGIZAADHBAAALBAAAJEbAAD2BgAAWxIAAMAdAAAlCQAAihQAAO8fAABUCwAAuRYAAB4CAACDDQAA6BgAAE0EAACyDwAA
| FxsAAHwGAADhEQAARh0AAKsIAAAQFAAAdR8AANoKAAA/FgAApAEAAAkNAABuGAAA0wMAADgPAACdGgAAAgYAAGcRAADMHAAA
| MQgAAJYTAAD7HgAAYAoAAMUVAAAqAQAAjwwAAPQXAABZAwAAvg4AACMaAACIBQAA7RAAAFIcAAC3BwAAHBMAAIEeAADmCQAA
| SxUAALAAAAAVDAAAehcAAN8CAABEDgAAqRkAAA4FAABzEAAA2BsAAD0HAACiEgAABx4AAGwJAADRFAAANgAAAJsLAAAAFwAA
| ZQIAAMoNAAAvGQAAlAQAAPkPAABeGwAAwwYAACgSAACNHQAA8ggAAFcUAAC8HwAAIQsAAIYWAADrAQAAUA0AALUYAAAaBAAA
| fw8AAOQaAABJBgAArhEAABMdAAB4CAAA3RMAAEIfAACnCgAADBYAAHEBAADWDAAAOxgAAKADAAAFDwAAahoAAM8FAAA0EQAA
| mRwAAP4HAABjEwAAyB4AAC0KAACSFQAA9wAAAFwMAADBFwAAJgMAAIsOAADwGQAAVQUAALoQAAAfHAAAhAcAAOkSAABOHgAA
| swkAABgVAAB9AAAA4gsAAIwDAADxDgAAVhoAALsFAAAgEQAAhRwAAOoHAABPEwAAtB4AABkKAAB+FQAA4wAAAEgMAACtFwAA
| EgMAAHcOAADcGQAAQQUAAKYQAAALHAAAcAcAANUSAAA6HgAAnwkAAAQVAABpAAAAzgsAADMXAACYAgAA/Q0AAGIZAADHBAAA
| LBAAAJEbAAD2BgAAWxIAAMAdAAAlCQAAihQAAO8fAABUCwAAuRYAAB4CAACDDQAA6BgAAE0EAACyDwAAFxsAAHwGAADhEQAA
| Rh0AAKsIAAAQFAAAdR8AANoKAAA/FgAApAEAAAkNAABuGAAA0wMAADgPAACdGgAAAgYAAGcRAADMHAAAMQgAAJYTAAD7HgAA
| YAoAAMUVAAAqAQAAjwwAAPQXAABZAwAAvg4AACMaAACIBQAA7RAAAFIcAAC3BwAAHBMAAIEeAADmCQAASxUAALAAAAAVDAAA
| ehcAAN8CAABEDgAAqRkAAA4FAABzEAAA2BsAAD0HAACiEgAABx4AAGwJAADRFAAANgAAAJsLAAAAFwAAZQIAAMoNAAAvGQAA
| lAQAAPkPAABeGwAAwwYAACgSAACNHQAA8ggAAFcUAAC8HwAAIQsAAIYWAADrAQAAUA0AALUYAAAaBAAAfw8AAOQaAABJBgAA
| rhEAABMdAAB4CAAA3RMAAEIfAACnCgAADBYAAHEBAADWDAAAOxgAAKADAAAFDwAAahoAAM8FAAA0EQAAmRwAAP4HAABjEwAA
| yB4AAC0KAACSFQAA9wAAAFwMAADBFwAAJgMAAIsOAADwGQAAVQUAALoQAAAfHAAAhAcAAOkSAABOHgAAswkAABgVAAB9AAAA
| 4gsAAEcXAACsAgAAEQ4AAHYZAADbBAAAQBAAAKUbAAAKBwAAbxIAANQdAAA5CQAAnhQAAAMAAABoCwAAzRYAADICAACXDQAA
| /BgAAGEEAADGDwAAKxsAAJAGAAD1EQAAWh0AAL8IAAAkFAAAiR8AAO4KAABTFgAAuAEAAB0NAACCGAAA5wMAAEwPAACxGgAA
| FgYAAHsRAADgHAAARQgAAKoTAAAPHwAAdAoAANkVAAA+AQAAowwAAAgYAABtAwAA0g4AADcaAACcBQAAAREAAGYcAADLBwAA
| MBMAAJUeAAD6CQAAXxUAAMQAAAApDAAAjhcAAPMCAABYDgAAvRkAACIFAACHEAAA7BsAAFEHAAC2EgAAGx4AAIAJAADlFAAA
| SgAAAK8LAAAUFwAAeQIAAN4NAABDGQAAqAQAAA0QAAByGwAA1wYAADwSAAChHQAABgkAAGsUAADQHwAANQsAAJoWAAD/AQAA
| ZA0AAMkYAAAuBAAAkw8AAPgaAABdBgAAwhEAACcdAADRFAAANgAAAJsLAAAAFwAAZQIAAMoNAAAvGQAAlAQAAPkPAABeGwAA
| wwYAACgSAACNHQAA8ggAAFcUAAC8HwAAIQsAAIYWAADrAQAAUA0AALUYAAAaBAAAfw8AAOQaAABJBgAArhEAABMdAAB4CAAA
| 3RMAAEIfAACnCgAADBYAAHEBAADWDAAAOxgAAKADAAAFDwAAahoAAM8FAAA0EQAAmRwAAP4HAABjEwAAyB4AAC0KAACSFQAA
| 9wAAAFwMAADBFwAAJgMAAIsOAADwGQAAVQUAALoQAAAfHAAAhAcAAOkSAABOHgAAswkAABgVAAB9AAAA4gsAAEcXAACsAgAA
| EQ4AAHYZAADbBAAAQBAAAKUbAAAKBwAAbxIAANQdAAA5CQAAnhQAAAMAAABoCwAAzRYAADICAACXDQAA/BgAAGEEAADGDwAA
| KxsAAJAGAAD1EQAAWh0AAL8IAAAkFAAAiR8AAO4KAABTFgAAuAEAAB0NAACCGAAA5wMAAEwPAACxGgAAFgYAAHsRAADgHAAA
| RQgAAKoTAAAPHwAAdAoAANkVAAA+AQAAowwAAAgYAABtAwAA0g4AADcaAACcBQAAAREAAGYcAADLBwAAMBMAAJUeAAD6CQAA
| XxUAAMQAAAApDAAAjhcAAPMCAABYDgAAvRkAACIFAACHEAAA7BsAAFEHAAC2EgAAGx4AAIAJAADlFAAASgAAAK8LAAAUFwAA
| eQIAAN4NAABDGQAAqAQAAA0QAAByGwAA1wYAADwSAAChHQAABgkAAGsUAADQHwAANQsAAJoWAAD/AQAAZA0AAMkYAAAuBAAA
| kw8AAPgaAABdBgAAwhEAACcdAACMCAAA8RMAAFYfAAC7CgAAIBYAAIUBAADqDAAATxgAALQDAAAZDwAAfhoAAOMFAABIEQAA
| rRwAABIIAAB3EwAA3B4AAEEKAACmFQAACwEAAHAMAADVFwAAOgMAAJ8OAAAEGgAAaQUAAM4QAAAzHAAAmAcAAP0SAABiHgAA
| xwkAACwVAACRAAAA9gsAAFsXAADAAgAAJQ4AAIoZAADvBAAAVBAAALkbAAAeBwAAgxIAAOgdAABNCQAAshQAABcAAAB8CwAA
| 4RYAAEYCAACrDQAAEBkAAHUEAADaDwAAPxsAAKQGAAAJEgAAbh0AANMIAAA4FAAAnR8AAAILAABnFgAAzAEAADENAACWGAAA
| +wMAAGAPAADFGgAAKgYAAI8RAAD0HAAAWQgAAL4TAAAjHwAAiAoAAO0VAABSAQAAtwwAABwYAACBAwAA5g4AAEsaAACwBQAA
| FREAAHocAADfBwAARBMAAKkeAAAOCgAAcxUAANgAAAA9DAAAohcAAAcDAABsDgAAFgYAAHsRAADgHAAARQgAAKoTAAAPHwAA
| dAoAANkVAAA+AQAAowwAAAgYAABtAwAA0g4AADcaAACcBQAAAREAAGYcAADLBwAAMBMAAJUeAAD6CQAAXxUAAMQAAAApDAAA
| jhcAAPMCAABYDgAAvRkAACIFAACHEAAA7BsAAFEHAAC2EgAAGx4AAIAJAADlFAAASgAAAK8LAAAUFwAAeQIAAN4NAABDGQAA
| qAQAAA0QAAByGwAA1wYAADwSAAChHQAABgkAAGsUAADQHwAANQsAAJoWAAD/AQAAZA0AAMkYAAAuBAAAkw8AAPgaAABdBgAA
| whEAACcdAACMCAAA8RMAAFYfAAC7CgAAIBYAAIUBAADqDAAATxgAALQDAAAZDwAAfhoAAOMFAABIEQAArRwAABIIAAB3EwAA
| 3B4AAEEKAACmFQAACwEAAHAMAADVFwAAOgMAAJ8OAAAEGgAAaQUAAM4QAAAzHAAAmAcAAP0SAABiHgAAxwkAACwVAACRAAAA
| 9gsAAFsXAADAAgAAJQ4AAIoZAADvBAAAVBAAALkbAAAeBwAAgxIAAOgdAABNCQAAshQAABcAAAB8CwAA4RYAAEYCAACrDQAA
| EBkAAHUEAADaDwAAPxsAAKQGAAAJEgAAbh0AANMIAAA4FAAAnR8AAAILAABnFgAAzAEAADENAACWGAAA+wMAAGAPAADFGgAA
| KgYAAI8RAAD0HAAAWQgAAL4TAAAjHwAAiAoAAO0VAABSAQAAtwwAABwYAACBAwAA5g4AAEsaAACwBQAAFREAAHocAADfBwAA
| RBMAAKkeAAAOCgAAcxUAANgAAAA9DAAAohcAAAcDAABsDgAA0RkAADYFAACbEAAAABwAAGUHAADKEgAALx4AAJQJAAD5FAAA
| XgAAAMMLAAAoFwAAjQIAAPINAABXGQAAvAQAACEQAACGGwAA6wYAAFASAAC1HQAAGgkAAH8UAADkHwAASQsAAK4WAAATAgAA
| eA0AAN0YAABCBAAApw8AAAwbAABxBgAA1hEAADsdAACgCAAABRQAAGofAADPCgAANBYAAJkBAAD+DAAAYxgAAMgDAAAtDwAA
| khoAAPcFAABcEQAAwRwAACYIAACLEwAA8B4AAFUKAAC6FQAAHwEAAIQMAADpFwAATgMAALMOAAAYGgAAfQUAAOIQAABHHAAA
| rAcAABETAAB2HgAA2wkAAEAVAAClAAAACgwAAG8XAADUAgAAOQ4AAJ4ZAAADBQAAaBAAAM0bAAAyBwAAlxIAAPwdAABhCQAA
| xhQAACsAAACQCwAA9RYAAFoCAAC/DQAAJBkAAIkEAADuDwAAUxsAALgGAAAdEgAAgh0AAOcIAABMFAAAsR8AAFsXAADAAgAA
| JQ4AAIoZAADvBAAAVBAAALkbAAAeBwAAgxIAAOgdAABNCQAAshQAABcAAAB8CwAA4RYAAEYCAACrDQAAEBkAAHUEAADaDwAA
| PxsAAKQGAAAJEgAAbh0AANMIAAA4FAAAnR8AAAILAABnFgAAzAEAADENAACWGAAA+wMAAGAPAADFGgAAKgYAAI8RAAD0HAAA
| WQgAAL4TAAAjHwAAiAoAAO0VAABSAQAAtwwAABwYAACBAwAA5g4AAEsaAACwBQAAFREAAHocAADfBwAARBMAAKkeAAAOCgAA
| cxUAANgAAAA9DAAAohcAAAcDAABsDgAA0RkAADYFAACbEAAAABwAAGUHAADKEgAALx4AAJQJAAD5FAAAXgAAAMMLAAAoFwAA
| jQIAAPINAABXGQAAvAQAACEQAACGGwAA6wYAAFASAAC1HQAAGgkAAH8UAADkHwAASQsAAK4WAAATAgAAeA0AAN0YAABCBAAA
| pw8AAAwbAABxBgAA1hEAADsdAACgCAAABRQAAGofAADPCgAANBYAAJkBAAD+DAAAYxgAAMgDAAAtDwAAkhoAAPcFAABcEQAA
| wRwAACYIAACLEwAA8B4AAFUKAAC6FQAAHwEAAIQMAADpFwAATgMAALMOAAAYGgAAfQUAAOIQAABHHAAArAcAABETAAB2HgAA
| 2wkAAEAVAAClAAAACgwAAG8XAADUAgAAOQ4AAJ4ZAAADBQAAaBAAAM0bAAAyBwAAlxIAAPwdAABhCQAAxhQAACsAAACQCwAA
| 9RYAAFoCAAC/DQAAJBkAAIkEAADuDwAAUxsAALgGAAAdEgAAgh0AAOcIAABMFAAAsR8AABYLAAB7FgAA4AEAAEUNAACqGAAA
| DwQAAHQPAADZGgAAPgYAAKMRAAAIHQAAbQgAANITAAA3HwAAnAoAAAEWAABmAQAAywwAADAYAACVAwAA+g4AAF8aAADEBQAA
| KREAAI4cAADzBwAAWBMAAL0eAAAiCgAAhxUAAOwAAABRDAAAthcAABsDAACADgAA5RkAAEoFAACvEAAAFBwAAHkHAADeEgAA
| Qx4AAKgJAAANFQAAcgAAANcLAAA8FwAAoQIAAAYOAABrGQAA0AQAADUQAACaGwAA/wYAAGQSAADJHQAALgkAAJMUAAD4HwAA
| XQsAAMIWAAAnAgAAjA0AAPEYAABWBAAAuw8AACAbAACFBgAA6hEAAE8dAAC0CAAAGRQAAH4fAADjCgAASBYAAK0BAAASDQAA
| dxgAANwDAABBDwAAphoAAAsGAABwEQAA1RwAADoIAACfEwAABB8AAGkKAADOFQAAMwEAAJgMAAD9FwAAYgMAAMcOAAAsGgAA
| kQUAAPYQAACgCAAABRQAAGofAADPCgAANBYAAJkBAAD+DAAAYxgAAMgDAAAtDwAAkhoAAPcFAABcEQAAwRwAACYIAACLEwAA
| 8B4AAFUKAAC6FQAAHwEAAIQMAADpFwAATgMAALMOAAAYGgAAfQUAAOIQAABHHAAArAcAABETAAB2HgAA2wkAAEAVAAClAAAA
| CgwAAG8XAADUAgAAOQ4AAJ4ZAAADBQAAaBAAAM0bAAAyBwAAlxIAAPwdAABhCQAAxhQAACsAAACQCwAA9RYAAFoCAAC/DQAA
| JBkAAIkEAADuDwAAUxsAALgGAAAdEgAAgh0AAOcIAABMFAAAsR8AABYLAAB7FgAA4AEAAEUNAACqGAAADwQAAHQPAADZGgAA
| PgYAAKMRAAAIHQAAbQgAANITAAA3HwAAnAoAAAEWAABmAQAAywwAADAYAACVAwAA+g4AAF8aAADEBQAAKREAAI4cAADzBwAA
| WBMAAL0eAAAiCgAAhxUAAOwAAABRDAAAthcAABsDAACADgAA5RkAAEoFAACvEAAAFBwAAHkHAADeEgAAQx4AAKgJAAANFQAA
| cgAAANcLAAA8FwAAoQIAAAYOAABrGQAA0AQAADUQAACaGwAA/wYAAGQSAADJHQAALgkAAJMUAAD4HwAAXQsAAMIWAAAnAgAA
| jA0AAPEYAABWBAAAuw8AACAbAACFBgAA6hEAAE8dAAC0CAAAGRQAAH4fAADjCgAASBYAAK0BAAASDQAAdxgAANwDAABBDwAA
| phoAAAsGAABwEQAA1RwAADoIAACfEwAABB8AAGkKAADOFQAAMwEAAJgMAAD9FwAAYgMAAMcOAAAsGgAAkQUAAPYQAABbHAAA
| wAcAACUTAACKHgAA7wkAAFQVAAC5AAAAHgwAAIMXAADoAgAATQ4AALIZAAAXBQAAfBAAAOEbAABGBwAAqxIAABAeAAB1CQAA
| 2hQAAD8AAACkCwAACRcAAG4CAADTDQAAOBkAAJ0EAAACEAAAZxsAAMwGAAAxEgAAlh0AAPsIAABgFAAAxR8AACoLAACPFgAA
| 9AEAAFkNAAC+GAAAIwQAAIgPAADtGgAAUgYAALcRAAAcHQAAgQgAAOYTAABLHwAAsAoAABUWAAB6AQAA3wwAAEQYAACpAwAA
| Dg8AAHMaAADYBQAAPREAAKIcAAAHCAAAbBMAANEeAAA2CgAAmxUAAAABAABlDAAAyhcAAC8DAACUDgAA+RkAAF4FAADDEAAA
| KBwAAI0HAADyEgAAVx4AALwJAAAhFQAAhgAAAOsLAABQFwAAtQIAABoOAAB/GQAA5AQAAEkQAACuGwAAEwcAAHgSAADdHQAA
| QgkAAKcUAAAMAAAAcQsAANYWAAA7AgAA5RkAAEoFAACvEAAAFBwAAHkHAADeEgAAQx4AAKgJAAANFQAAcgAAANcLAAA8FwAA
| oQIAAAYOAABrGQAA0AQAADUQAACaGwAA/wYAAGQSAADJHQAALgkAAJMUAAD4HwAAXQsAAMIWAAAnAgAAjA0AAPEYAABWBAAA
| uw8AACAbAACFBgAA6hEAAE8dAAC0CAAAGRQAAH4fAADjCgAASBYAAK0BAAASDQAAdxgAANwDAABBDwAAphoAAAsGAABwEQAA
| 1RwAADoIAACfEwAABB8AAGkKAADOFQAAMwEAAJgMAAD9FwAAYgMAAMcOAAAsGgAAkQUAAPYQAABbHAAAwAcAACUTAACKHgAA
| 7wkAAFQVAAC5AAAAHgwAAIMXAADoAgAATQ4AALIZAAAXBQAAfBAAAOEbAABGBwAAqxIAABAeAAB1CQAA2hQAAD8AAACkCwAA
| CRcAAG4CAADTDQAAOBkAAJ0EAAACEAAAZxsAAMwGAAAxEgAAlh0AAPsIAABgFAAAxR8AACoLAACPFgAA9AEAAFkNAAC+GAAA
| IwQAAIgPAADtGgAAUgYAALcRAAAcHQAAgQgAAOYTAABLHwAAsAoAABUWAAB6AQAA3wwAAEQYAACpAwAADg8AAHMaAADYBQAA
| PREAAKIcAAAHCAAAbBMAANEeAAA2CgAAmxUAAAABAABlDAAAyhcAAC8DAACUDgAA+RkAAF4FAADDEAAAKBwAAI0HAADyEgAA
| Vx4AALwJAAAhFQAAhgAAAOsLAABQFwAAtQIAABoOAAB/GQAA5AQAAEkQAACuGwAAEwcAAHgSAADdHQAAQgkAAKcUAAAMAAAA
| cQsAANYWAAA7AgAAoA0AAAUZAABqBAAAzw8AADQbAACZBgAA/hEAAGMdAADICAAALRQAAJIfAAD3CgAAXBYAAMEBAAAmDQAA
| ixgAAPADAABVDwAAuhoAAB8GAACEEQAA6RwAAE4IAACzEwAAGB8AAH0KAADiFQAARwEAAKwMAAARGAAAdgMAANsOAABAGgAA
| pQUAAAoRAABvHAAA1AcAADkTAACeHgAAAwoAAGgVAADNAAAAMgwAAJcXAAD8AgAAYQ4AAMYZAAArBQAAkBAAAPUbAABaBwAA
| vxIAACQeAACJCQAA7hQAAFMAAAC4CwAAHRcAAIICAADnDQAATBkAALEEAAAWEAAAexsAAOAGAABFEgAAqh0AAA8JAAB0FAAA
| 2R8AAD4LAACjFgAACAIAAG0NAADSGAAANwQAAJwPAAABGwAAZgYAAMsRAAAwHQAAlQgAAPoTAABfHwAAxAoAACkWAACOAQAA
| 8wwAAFgYAAC9AwAAIg8AAIcaAADsBQAAUREAALYcAAAbCAAAgBMAACoLAACPFgAA9AEAAFkNAAC+GAAAIwQAAIgPAADtGgAA
| UgYAALcRAAAcHQAAgQgAAOYTAABLHwAAsAoAABUWAAB6AQAA3wwAAEQYAACpAwAADg8AAHMaAADYBQAAPREAAKIcAAAHCAAA
| bBMAANEeAAA2CgAAmxUAAAABAABlDAAAyhcAAC8DAACUDgAA+RkAAF4FAADDEAAAKBwAAI0HAADyEgAAVx4AALwJAAAhFQAA
| hgAAAOsLAABQFwAAtQIAABoOAAB/GQAA5AQAAEkQAACuGwAAEwcAAHgSAADdHQAAQgkAAKcUAAAMAAAAcQsAANYWAAA7AgAA
| oA0AAAUZAABqBAAAzw8AADQbAACZBgAA/hEAAGMdAADICAAALRQAAJIfAAD3CgAAXBYAAMEBAAAmDQAAixgAAPADAABVDwAA
| uhoAAB8GAACEEQAA6RwAAE4IAACzEwAAGB8AAH0KAADiFQAARwEAAKwMAAARGAAAdgMAANsOAABAGgAApQUAAAoRAABvHAAA
| 1AcAADkTAACeHgAAAwoAAGgVAADNAAAAMgwAAJcXAAD8AgAAYQ4AAMYZAAArBQAAkBAAAPUbAABaBwAAvxIAACQeAACJCQAA
| 7hQAAFMAAAC4CwAAHRcAAIICAADnDQAATBkAALEEAAAWEAAAexsAAOAGAABFEgAAqh0AAA8JAAB0FAAA2R8AAD4LAACjFgAA
| CAIAAG0NAADSGAAANwQAAJwPAAABGwAAZgYAAMsRAAAwHQAAlQgAAPoTAABfHwAAxAoAACkWAACOAQAA8wwAAFgYAAC9AwAA
| Ig8AAIcaAADsBQAAUREAALYcAAAbCAAAgBMAAOUeAABKCgAArxUAABQBAAB5DAAA3hcAAEMDAACoDgAADRoAAHIFAADXEAAA
| PBwAAKEHAAAGEwAAax4AANAJAAA1FQAAmgAAAP8LAABkFwAAyQIAAC4OAACTGQAA+AQAAF0QAADCGwAAJwcAAIwSAADxHQAA
| VgkAALsUAAAgAAAAhQsAAOoWAABPAgAAtA0AABkZAAB+BAAA4w8AAEgbAACtBgAAEhIAAHcdAADcCAAAQRQAAKYfAAALCwAA
| cBYAANUBAAA6DQAAnxgAAAQEAABpDwAAzhoAADMGAACYEQAA/RwAAGIIAADHEwAALB8AAJEKAAD2FQAAWwEAAMAMAAAlGAAA
| igMAAO8OAABUGgAAuQUAAB4RAACDHAAA6AcAAE0TAACyHgAAFwoAAHwVAADhAAAARgwAAKsXAAAQAwAAdQ4AANoZAAA/BQAA
| pBAAAAkcAABuBwAA0xIAADgeAACdCQAAAhUAAGcAAADMCwAAMRcAAJYCAAD7DQAAYBkAAMUEAABvHAAA1AcAADkTAACeHgAA
| AwoAAGgVAADNAAAAMgwAAJcXAAD8AgAAYQ4AAMYZAAArBQAAkBAAAPUbAABaBwAAvxIAACQeAACJCQAA7hQAAFMAAAC4CwAA
| HRcAAIICAADnDQAATBkAALEEAAAWEAAAexsAAOAGAABFEgAAqh0AAA8JAAB0FAAA2R8AAD4LAACjFgAACAIAAG0NAADSGAAA
| NwQAAJwPAAABGwAAZgYAAMsRAAAwHQAAlQgAAPoTAABfHwAAxAoAACkWAACOAQAA8wwAAFgYAAC9AwAAIg8AAIcaAADsBQAA
| UREAALYcAAAbCAAAgBMAAOUeAABKCgAArxUAABQBAAB5DAAA3hcAAEMDAACoDgAADRoAAHIFAADXEAAAPBwAAKEHAAAGEwAA
| ax4AANAJAAA1FQAAmgAAAP8LAABkFwAAyQIAAC4OAACTGQAA+AQAAF0QAADCGwAAJwcAAIwSAADxHQAAVgkAALsUAAAgAAAA
| hQsAAOoWAABPAgAAtA0AABkZAAB+BAAA4w8AAEgbAACtBgAAEhIAAHcdAADcCAAAQRQAAKYfAAALCwAAcBYAANUBAAA6DQAA
| nxgAAAQEAABpDwAAzhoAADMGAACYEQAA/RwAAGIIAADHEwAALB8AAJEKAAD2FQAAWwEAAMAMAAAlGAAAigMAAO8OAABUGgAA
| uQUAAB4RAACDHAAA6AcAAE0TAACyHgAAFwoAAHwVAADhAAAARgwAAKsXAAAQAwAAdQ4AANoZAAA/BQAApBAAAAkcAABuBwAA
| 0xIAADgeAACdCQAAAhUAAGcAAADMCwAAMRcAAJYCAAD7DQAAYBkAAMUEAAAqEAAAjxsAAPQGAABZEgAAvh0AACMJAACIFAAA
| 7R8AAFILAAC3FgAAHAIAAIENAADmGAAASwQAALAPAAAVGwAAegYAAN8RAABEHQAAqQgAAA4UAABzHwAA2AoAAD0WAACiAQAA
| Bw0AAGwYAADRAwAANg8AAJsaAAAABgAAZREAAMocAAAvCAAAlBMAAPkeAABeCgAAwxUAACgBAACNDAAA8hcAAFcDAAC8DgAA
| IRoAAIYFAADrEAAAUBwAALUHAAAaEwAAfx4AAOQJAABJFQAArgAAABMMAAB4FwAA3QIAAEIOAACnGQAADAUAAHEQAADWGwAA
| OwcAAKASAAAFHgAAagkAAM8UAAA0AAAAmQsAAP4WAABjAgAAyA0AAC0ZAACSBAAA9w8AAFwbAADBBgAAJhIAAIsdAADwCAAA
| VRQAALofAAAfCwAAhBYAAOkBAABODQAAsxgAABgEAAB9DwAA4hoAAEcGAACsEQAAER0AAHYIAADbEwAAQB8AAKUKAAAKFgAA
| tA0AABkZAAB+BAAA4w8AAEgbAACtBgAAEhIAAHcdAADcCAAAQRQAAKYfAAALCwAAcBYAANUBAAA6DQAAnxgAAAQEAABpDwAA
| zhoAADMGAACYEQAA/RwAAGIIAADHEwAALB8AAJEKAAD2FQAAWwEAAMAMAAAlGAAAigMAAO8OAABUGgAAuQUAAB4RAACDHAAA
| 6AcAAE0TAACyHgAAFwoAAHwVAADhAAAARgwAAKsXAAAQAwAAdQ4AANoZAAA/BQAApBAAAAkcAABuBwAA0xIAADgeAACdCQAA
| AhUAAGcAAADMCwAAMRcAAJYCAAD7DQAAYBkAAMUEAAAqEAAAjxsAAPQGAABZEgAAvh0AACMJAACIFAAA7R8AAFILAAC3FgAA
| HAIAAIENAADmGAAASwQAALAPAAAVGwAAegYAAN8RAABEHQAAqQgAAA4UAABzHwAA2AoAAD0WAACiAQAABw0AAGwYAADRAwAA
| Ng8AAJsaAAAABgAAZREAAMocAAAvCAAAlBMAAPkeAABeCgAAwxUAACgBAACNDAAA8hcAAFcDAAC8DgAAIRoAAIYFAADrEAAA
| UBwAALUHAAAaEwAAfx4AAOQJAABJFQAArgAAABMMAAB4FwAA3QIAAEIOAACnGQAADAUAAHEQAADWGwAAOwcAAKASAAAFHgAA
| agkAAM8UAAA0AAAAmQsAAP4WAABjAgAAyA0AAC0ZAACSBAAA9w8AAFwbAADBBgAAJhIAAIsdAADwCAAAVRQAALofAAAfCwAA
| hBYAAOkBAABODQAAsxgAABgEAAB9DwAA4hoAAEcGAACsEQAAER0AAHYIAADbEwAAQB8AAKUKAAAKFgAAbwEAANQMAAA5GAAA
| ngMAAAMPAABoGgAAzQUAADIRAACXHAAA/AcAAGETAADGHgAAKwoAAJAVAAD1AAAAWgwAAL8XAAAkAwAAiQ4AAO4ZAABTBQAA
| uBAAAB0cAACCBwAA5xIAAEweAACxCQAAFhUAAHsAAADgCwAARRcAAKoCAAAPDgAAdBkAANkEAAA+EAAAoxsAAAgHAABtEgAA
| 0h0AADcJAACcFAAAAQAAAGYLAADLFgAAMAIAAJUNAAD6GAAAXwQAAMQPAAApGwAAjgYAAPMRAABYHQAAvQgAACIUAACHHwAA
| 7AoAAFEWAAC2AQAAGw0AAIAYAADlAwAASg8AAK8aAAAUBgAAeREAAN4cAABDCAAAqBMAAA0fAAByCgAA1xUAADwBAAChDAAA
| BhgAAGsDAADQDgAANRoAAJoFAAD/EAAAZBwAAMkHAAAuEwAAkx4AAPgJAABdFQAAwgAAACcMAACMFwAA8QIAAFYOAAC7GQAA
| IAUAAIUQAADqGwAATwcAAPkeAABeCgAAwxUAACgBAACNDAAA8hcAAFcDAAC8DgAAIRoAAIYFAADrEAAAUBwAALUHAAAaEwAA
| fx4AAOQJAABJFQAArgAAABMMAAB4FwAA3QIAAEIOAACnGQAADAUAAHEQAADWGwAAOwcAAKASAAAFHgAAagkAAM8UAAA0AAAA
| mQsAAP4WAABjAgAAyA0AAC0ZAACSBAAA9w8AAFwbAADBBgAAJhIAAIsdAADwCAAAVRQAALofAAAfCwAAhBYAAOkBAABODQAA
| sxgAABgEAAB9DwAA4hoAAEcGAACsEQAAER0AAHYIAADbEwAAQB8AAKUKAAAKFgAAbwEAANQMAAA5GAAAngMAAAMPAABoGgAA
| zQUAADIRAACXHAAA/AcAAGETAADGHgAAKwoAAJAVAAD1AAAAWgwAAL8XAAAkAwAAiQ4AAO4ZAABTBQAAuBAAAB0cAACCBwAA
| 5xIAAEweAACxCQAAFhUAAHsAAADgCwAARRcAAKoCAAAPDgAAdBkAANkEAAA+EAAAoxsAAAgHAABtEgAA0h0AADcJAACcFAAA
| AQAAAGYLAADLFgAAMAIAAJUNAAD6GAAAXwQAAMQPAAApGwAAjgYAAPMRAABYHQAAvQgAACIUAACHHwAA7AoAAFEWAAC2AQAA
| Gw0AAIAYAADlAwAASg8AAK8aAAAUBgAAeREAAN4cAABDCAAAqBMAAA0fAAByCgAA1xUAADwBAAChDAAABhgAAGsDAADQDgAA
| NRoAAJoFAAD/EAAAZBwAAMkHAAAuEwAAkx4AAPgJAABdFQAAwgAAACcMAACMFwAA8QIAAFYOAAC7GQAAIAUAAIUQAADqGwAA
| TwcAALQSAAAZHgAAfgkAAOMUAABIAAAArQsAABIXAAB3AgAA3A0AAEEZAACmBAAACxAAAHAbAADVBgAAOhIAAJ8dAAAECQAA
| aRQAAM4fAAAzCwAAmBYAAP0BAABiDQAAxxgAACwEAACRDwAA9hoAAFsGAADAEQAAJR0AAIoIAADvEwAAVB8AALkKAAAeFgAA
| gwEAAOgMAABNGAAAsgMAABcPAAB8GgAA4QUAAEYRAACrHAAAEAgAAHUTAADaHgAAPwoAAKQVAAAJAQAAbgwAANMXAAA4AwAA
| nQ4AAAIaAABnBQAAzBAAADEcAACWBwAA+xIAAGAeAADFCQAAKhUAAI8AAAD0CwAAWRcAAL4CAAAjDgAAiBkAAO0EAABSEAAA
| txsAABwHAACBEgAA5h0AAEsJAACwFAAAFQAAAHoLAADfFgAARAIAAKkNAAAOGQAAcwQAANgPAAA9GwAAogYAAAcSAABsHQAA
| 0QgAADYUAACbHwAAAAsAAGUWAADKAQAALw0AAJQYAAA+EAAAoxsAAAgHAABtEgAA0h0AADcJAACcFAAAAQAAAGYLAADLFgAA
| MAIAAJUNAAD6GAAAXwQAAMQPAAApGwAAjgYAAPMRAABYHQAAvQgAACIUAACHHwAA7AoAAFEWAAC2AQAAGw0AAIAYAADlAwAA
| Sg8AAK8aAAAUBgAAeREAAN4cAABDCAAAqBMAAA0fAAByCgAA1xUAADwBAAChDAAABhgAAGsDAADQDgAANRoAAJoFAAD/EAAA
| ZBwAAMkHAAAuEwAAkx4AAPgJAABdFQAAwgAAACcMAACMFwAA8QIAAFYOAAC7GQAAIAUAAIUQAADqGwAATwcAALQSAAAZHgAA
| fgkAAOMUAABIAAAArQsAABIXAAB3AgAA3A0AAEEZAACmBAAACxAAAHAbAADVBgAAOhIAAJ8dAAAECQAAaRQAAM4fAAAzCwAA
| mBYAAP0BAABiDQAAxxgAACwEAACRDwAA9hoAAFsGAADAEQAAJR0AAIoIAADvEwAAVB8AALkKAAAeFgAAgwEAAOgMAABNGAAA
| sgMAABcPAAB8GgAA4QUAAEYRAACrHAAAEAgAAHUTAADaHgAAPwoAAKQVAAAJAQAAbgwAANMXAAA4AwAAnQ4AAAIaAABnBQAA
| zBAAADEcAACWBwAA+xIAAGAeAADFCQAAKhUAAI8AAAD0CwAAWRcAAL4CAAAjDgAAiBkAAO0EAABSEAAAtxsAABwHAACBEgAA
| 5h0AAEsJAACwFAAAFQAAAHoLAADfFgAARAIAAKkNAAAOGQAAcwQAANgPAAA9GwAAogYAAAcSAABsHQAA0QgAADYUAACbHwAA
| AAsAAGUWAADKAQAALw0AAJQYAAD5AwAAXg8AAMMaAAAoBgAAjREAAPIcAABXCAAAvBMAACEfAACGCgAA6xUAAFABAAC1DAAA
| GhgAAH8DAADkDgAASRoAAK4FAAATEQAAeBwAAN0HAABCEwAApx4AAAwKAABxFQAA1gAAADsMAACgFwAABQMAAGoOAADPGQAA
| NAUAAJkQAAD+GwAAYwcAAMgSAAAtHgAAkgkAAPcUAABcAAAAwQsAACYXAACLAgAA8A0AAFUZAAC6BAAAHxAAAIQbAADpBgAA
| ThIAALMdAAAYCQAAfRQAAOIfAABHCwAArBYAABECAAB2DQAA2xgAAEAEAAClDwAAChsAAG8GAADUEQAAOR0AAJ4IAAADFAAA
| aB8AAM0KAAAyFgAAlwEAAPwMAABhGAAAxgMAACsPAACQGgAA9QUAAFoRAAC/HAAAJAgAAIkTAADuHgAAUwoAALgVAAAdAQAA
| ggwAAOcXAABMAwAAsQ4AABYaAAB7BQAA4BAAAEUcAACqBwAADxMAAHQeAADZCQAAgwEAAOgMAABNGAAAsgMAABcPAAB8GgAA
| 4QUAAEYRAACrHAAAEAgAAHUTAADaHgAAPwoAAKQVAAAJAQAAbgwAANMXAAA4AwAAnQ4AAAIaAABnBQAAzBAAADEcAACWBwAA
| +xIAAGAeAADFCQAAKhUAAI8AAAD0CwAAWRcAAL4CAAAjDgAAiBkAAO0EAABSEAAAtxsAABwHAACBEgAA5h0AAEsJAACwFAAA
| FQAAAHoLAADfFgAARAIAAKkNAAAOGQAAcwQAANgPAAA9GwAAogYAAAcSAABsHQAA0QgAADYUAACbHwAAAAsAAGUWAADKAQAA
| Lw0AAJQYAAD5AwAAXg8AAMMaAAAoBgAAjREAAPIcAABXCAAAvBMAACEfAACGCgAA6xUAAFABAAC1DAAAGhgAAH8DAADkDgAA
| SRoAAK4FAAATEQAAeBwAAN0HAABCEwAApx4AAAwKAABxFQAA1gAAADsMAACgFwAABQMAAGoOAADPGQAANAUAAJkQAAD+GwAA
| YwcAAMgSAAAtHgAAkgkAAPcUAABcAAAAwQsAACYXAACLAgAA8A0AAFUZAAC6BAAAHxAAAIQbAADpBgAAThIAALMdAAAYCQAA
| fRQAAOIfAABHCwAArBYAABECAAB2DQAA2xgAAEAEAAClDwAAChsAAG8GAADUEQAAOR0AAJ4IAAADFAAAaB8AAM0KAAAyFgAA
| lwEAAPwMAABhGAAAxgMAACsPAACQGgAA9QUAAFoRAAC/HAAAJAgAAIkTAADuHgAAUwoAALgVAAAdAQAAggwAAOcXAABMAwAA
| sQ4AABYaAAB7BQAA4BAAAEUcAACqBwAADxMAAHQeAADZCQAAPhUAAKMAAAAIDAAAbRcAANICAAA3DgAAnBkAAAEFAABmEAAA
| yxsAADAHAACVEgAA+h0AAF8JAADEFAAAKQAAAI4LAADzFgAAWAIAAL0NAAAiGQAAhwQAAOwPAABRGwAAtgYAABsSAACAHQAA
| 5QgAAEoUAACvHwAAFAsAAHkWAADeAQAAQw0AAKgYAAANBAAAcg8AANcaAAA8BgAAoREAAAYdAABrCAAA0BMAADUfAACaCgAA
| /xUAAGQBAADJDAAALhgAAJMDAAD4DgAAXRoAAMIFAAAnEQAAjBwAAPEHAABWEwAAux4AACAKAACFFQAA6gAAAE8MAAC0FwAA
| GQMAAH4OAADjGQAASAUAAK0QAAASHAAAdwcAANwSAABBHgAApgkAAAsVAABwAAAA1QsAADoXAACfAgAABA4AAGkZAADOBAAA
| MxAAAJgbAAD9BgAAYhIAAMcdAAAsCQAAkRQAAPYfAABbCwAAwBYAACUCAACKDQAA7xgAAFQEAAC5DwAAHhsAAMgSAAAtHgAA
| kgkAAPcUAABcAAAAwQsAACYXAACLAgAA8A0AAFUZAAC6BAAAHxAAAIQbAADpBgAAThIAALMdAAAYCQAAfRQAAOIfAABHCwAA
| rBYAABECAAB2DQAA2xgAAEAEAAClDwAAChsAAG8GAADUEQAAOR0AAJ4IAAADFAAAaB8AAM0KAAAyFgAAlwEAAPwMAABhGAAA
| xgMAACsPAACQGgAA9QUAAFoRAAC/HAAAJAgAAIkTAADuHgAAUwoAALgVAAAdAQAAggwAAOcXAABMAwAAsQ4AABYaAAB7BQAA
| 4BAAAEUcAACqBwAADxMAAHQeAADZCQAAPhUAAKMAAAAIDAAAbRcAANICAAA3DgAAnBkAAAEFAABmEAAAyxsAADAHAACVEgAA
| +h0AAF8JAADEFAAAKQAAAI4LAADzFgAAWAIAAL0NAAAiGQAAhwQAAOwPAABRGwAAtgYAABsSAACAHQAA5QgAAEoUAACvHwAA
| FAsAAHkWAADeAQAAQw0AAKgYAAANBAAAcg8AANcaAAA8BgAAoREAAAYdAABrCAAA0BMAADUfAACaCgAA/xUAAGQBAADJDAAA
| LhgAAJMDAAD4DgAAXRoAAMIFAAAnEQAAjBwAAPEHAABWEwAAux4AACAKAACFFQAA6gAAAE8MAAC0FwAAGQMAAH4OAADjGQAA
| SAUAAK0QAAASHAAAdwcAANwSAABBHgAApgkAAAsVAABwAAAA1QsAADoXAACfAgAABA4AAGkZAADOBAAAMxAAAJgbAAD9BgAA
| YhIAAMcdAAAsCQAAkRQAAPYfAABbCwAAwBYAACUCAACKDQAA7xgAAFQEAAC5DwAAHhsAAIMGAADoEQAATR0AALIIAAAXFAAA
| fB8AAOEKAABGFgAAqwEAABANAAB1GAAA2gMAAD8PAACkGgAACQYAAG4RAADTHAAAOAgAAJ0TAAACHwAAZwoAAMwVAAAxAQAA
| lgwAAPsXAABgAwAAxQ4AACoaAACPBQAA9BAAAFkcAAC+BwAAIxMAAIgeAADtCQAAUhUAALcAAAAcDAAAgRcAAOYCAABLDgAA
| sBkAABUFAAB6EAAA3xsAAEQHAACpEgAADh4AAHMJAADYFAAAPQAAAKILAAAHFwAAbAIAANENAAA2GQAAmwQAAAAQAABlGwAA
| ygYAAC8SAACUHQAA+QgAAF4UAADDHwAAKAsAAI0WAADyAQAAVw0AALwYAAAhBAAAhg8AAOsaAABQBgAAtREAABodAAB/CAAA
| 5BMAAEkfAACuCgAAExYAAHgBAADdDAAAQhgAAKcDAAAMDwAAcRoAANYFAAA7EQAAoBwAAAUIAABqEwAAzx4AADQKAACZFQAA
| /gAAAGMMAAANBAAAcg8AANcaAAA8BgAAoREAAAYdAABrCAAA0BMAADUfAACaCgAA/xUAAGQBAADJDAAALhgAAJMDAAD4DgAA
| XRoAAMIFAAAnEQAAjBwAAPEHAABWEwAAux4AACAKAACFFQAA6gAAAE8MAAC0FwAAGQMAAH4OAADjGQAASAUAAK0QAAASHAAA
| dwcAANwSAABBHgAApgkAAAsVAABwAAAA1QsAADoXAACfAgAABA4AAGkZAADOBAAAMxAAAJgbAAD9BgAAYhIAAMcdAAAsCQAA
| kRQAAPYfAABbCwAAwBYAACUCAACKDQAA7xgAAFQEAAC5DwAAHhsAAIMGAADoEQAATR0AALIIAAAXFAAAfB8AAOEKAABGFgAA
| qwEAABANAAB1GAAA2gMAAD8PAACkGgAACQYAAG4RAADTHAAAOAgAAJ0TAAACHwAAZwoAAMwVAAAxAQAAlgwAAPsXAABgAwAA
| xQ4AACoaAACPBQAA9BAAAFkcAAC+BwAAIxMAAIgeAADtCQAAUhUAALcAAAAcDAAAgRcAAOYCAABLDgAAsBkAABUFAAB6EAAA
| 3xsAAEQHAACpEgAADh4AAHMJAADYFAAAPQAAAKILAAAHFwAAbAIAANENAAA2GQAAmwQAAAAQAABlGwAAygYAAC8SAACUHQAA
| +QgAAF4UAADDHwAAKAsAAI0WAADyAQAAVw0AALwYAAAhBAAAhg8AAOsaAABQBgAAtREAABodAAB/CAAA5BMAAEkfAACuCgAA
| ExYAAHgBAADdDAAAQhgAAKcDAAAMDwAAcRoAANYFAAA7EQAAoBwAAAUIAABqEwAAzx4AADQKAACZFQAA/gAAAGMMAADIFwAA
| LQMAAJIOAAD3GQAAXAUAAMEQAAAmHAAAiwcAAPASAABVHgAAugkAAB8VAACEAAAA6QsAAE4XAACzAgAAGA4AAH0ZAADiBAAA
| RxAAAKwbAAARBwAAdhIAANsdAABACQAApRQAAAoAAABvCwAA1BYAADkCAACeDQAAAxkAAGgEAADNDwAAMhsAAJcGAAD8EQAA
| YR0AAMYIAAArFAAAkB8AAPUKAABaFgAAvwEAACQNAACJGAAA7gMAAFMPAAC4GgAAHQYAAIIRAADnHAAATAgAALETAAAWHwAA
| ewoAAOAVAABFAQAAqgwAAA8YAAB0AwAA2Q4AAD4aAACjBQAACBEAAG0cAADSBwAANxMAAJweAAABCgAAZhUAAMsAAAAwDAAA
| lRcAAPoCAABfDgAAxBkAACkFAACOEAAA8xsAAFgHAAC9EgAAIh4AAIcJAADsFAAAUQAAALYLAAAbFwAAgAIAAOUNAABKGQAA
| rwQAABQQAAB5GwAA3gYAAEMSAACoHQAAUhUAALcAAAAcDAAAgRcAAOYCAABLDgAAsBkAABUFAAB6EAAA3xsAAEQHAACpEgAA
| Dh4AAHMJAADYFAAAPQAAAKILAAAHFwAAbAIAANENAAA2GQAAmwQAAAAQAABlGwAAygYAAC8SAACUHQAA+QgAAF4UAADDHwAA
| KAsAAI0WAADyAQAAVw0AALwYAAAhBAAAhg8AAOsaAABQBgAAtREAABodAAB/CAAA5BMAAEkfAACuCgAAExYAAHgBAADdDAAA
| QhgAAKcDAAAMDwAAcRoAANYFAAA7EQAAoBwAAAUIAABqEwAAzx4AADQKAACZFQAA/gAAAGMMAADIFwAALQMAAJIOAAD3GQAA
| XAUAAMEQAAAmHAAAiwcAAPASAABVHgAAugkAAB8VAACEAAAA6QsAAE4XAACzAgAAGA4AAH0ZAADiBAAARxAAAKwbAAARBwAA
| dhIAANsdAABACQAApRQAAAoAAABvCwAA1BYAADkCAACeDQAAAxkAAGgEAADNDwAAMhsAAJcGAAD8EQAAYR0AAMYIAAArFAAA
| kB8AAPUKAABaFgAAvwEAACQNAACJGAAA7gMAAFMPAAC4GgAAHQYAAIIRAADnHAAATAgAALETAAAWHwAAewoAAOAVAABFAQAA
| qgwAAA8YAAB0AwAA2Q4AAD4aAACjBQAACBEAAG0cAADSBwAANxMAAJweAAABCgAAZhUAAMsAAAAwDAAAlRcAAPoCAABfDgAA
| xBkAACkFAACOEAAA8xsAAFgHAAC9EgAAIh4AAIcJAADsFAAAUQAAALYLAAAbFwAAgAIAAOUNAABKGQAArwQAABQQAAB5GwAA
| 3gYAAEMSAACoHQAADQkAAHIUAADXHwAAPAsAAKEWAAAGAgAAaw0AANAYAAA1BAAAmg8AAP8aAABkBgAAyREAAC4dAACTCAAA
| +BMAAF0fAADCCgAAJxYAAIwBAADxDAAAVhgAALsDAAAgDwAAhRoAAOoFAABPEQAAtBwAABkIAAB+EwAA4x4AAEgKAACtFQAA
| EgEAAHcMAADcFwAAQQMAAKYOAAALGgAAcAUAANUQAAA6HAAAnwcAAAQTAABpHgAAzgkAADMVAACYAAAA/QsAAGIXAADHAgAA
| LA4AAJEZAAD2BAAAWxAAAMAbAAAlBwAAihIAAO8dAABUCQAAuRQAAB4AAACDCwAA6BYAAE0CAACyDQAAFxkAAHwEAADhDwAA
| RhsAAKsGAAAQEgAAdR0AANoIAAA/FAAApB8AAAkLAABuFgAA0wEAADgNAACdGAAAAgQAAGcPAADMGgAAMQYAAJYRAAD7HAAA
| YAgAAMUTAAAqHwAAjwoAAPQVAABZAQAAvgwAACMYAACIAwAA7Q4AAJcGAAD8EQAAYR0AAMYIAAArFAAAkB8AAPUKAABaFgAA
| vwEAACQNAACJGAAA7gMAAFMPAAC4GgAAHQYAAIIRAADnHAAATAgAALETAAAWHwAAewoAAOAVAABFAQAAqgwAAA8YAAB0AwAA
| 2Q4AAD4aAACjBQAACBEAAG0cAADSBwAANxMAAJweAAABCgAAZhUAAMsAAAAwDAAAlRcAAPoCAABfDgAAxBkAACkFAACOEAAA
| 8xsAAFgHAAC9EgAAIh4AAIcJAADsFAAAUQAAALYLAAAbFwAAgAIAAOUNAABKGQAArwQAABQQAAB5GwAA3gYAAEMSAACoHQAA
| DQkAAHIUAADXHwAAPAsAAKEWAAAGAgAAaw0AANAYAAA1BAAAmg8AAP8aAABkBgAAyREAAC4dAACTCAAA+BMAAF0fAADCCgAA
| JxYAAIwBAADxDAAAVhgAALsDAAAgDwAAhRoAAOoFAABPEQAAtBwAABkIAAB+EwAA4x4AAEgKAACtFQAAEgEAAHcMAADcFwAA
| QQMAAKYOAAALGgAAcAUAANUQAAA6HAAAnwcAAAQTAABpHgAAzgkAADMVAACYAAAA/QsAAGIXAADHAgAALA4AAJEZAAD2BAAA
| WxAAAMAbAAAlBwAAihIAAO8dAABUCQAAuRQAAB4AAACDCwAA6BYAAE0CAACyDQAAFxkAAHwEAADhDwAARhsAAKsGAAAQEgAA
| dR0AANoIAAA/FAAApB8AAAkLAABuFgAA0wEAADgNAACdGAAAAgQAAGcPAADMGgAAMQYAAJYRAAD7HAAAYAgAAMUTAAAqHwAA
| jwoAAPQVAABZAQAAvgwAACMYAACIAwAA7Q4AAFIaAAC3BQAAHBEAAIEcAADmBwAASxMAALAeAAAVCgAAehUAAN8AAABEDAAA
| qRcAAA4DAABzDgAA2BkAAD0FAACiEAAABxwAAGwHAADREgAANh4AAJsJAAAAFQAAZQAAAMoLAAAvFwAAlAIAAPkNAABeGQAA
| wwQAACgQAACNGwAA8gYAAFcSAAC8HQAAIQkAAIYUAADrHwAAUAsAALUWAAAaAgAAfw0AAOQYAABJBAAArg8AABMbAAB4BgAA
| 3REAAEIdAACnCAAADBQAAHEfAADWCgAAOxYAAKABAAAFDQAAahgAAM8DAAA0DwAAmRoAAP4FAABjEQAAyBwAAC0IAACSEwAA
| 9x4AAFwKAADBFQAAJgEAAIsMAADwFwAAVQMAALoOAAAfGgAAhAUAAOkQAABOHAAAswcAABgTAAB9HgAA4gkAAEcVAACsAAAA
| EQwAAHYXAADbAgAAQA4AAKUZAAAKBQAAbxAAANQbAAA5BwAAnhIAAAMeAABoCQAAzRQAADIAAADcFwAAQQMAAKYOAAALGgAA
| cAUAANUQAAA6HAAAnwcAAAQTAABpHgAAzgkAADMVAACYAAAA/QsAAGIXAADHAgAALA4AAJEZAAD2BAAAWxAAAMAbAAAlBwAA
| ihIAAO8dAABUCQAAuRQAAB4AAACDCwAA6BYAAE0CAACyDQAAFxkAAHwEAADhDwAARhsAAKsGAAAQEgAAdR0AANoIAAA/FAAA
| pB8AAAkLAABuFgAA0wEAADgNAACdGAAAAgQAAGcPAADMGgAAMQYAAJYRAAD7HAAAYAgAAMUTAAAqHwAAjwoAAPQVAABZAQAA
| vgwAACMYAACIAwAA7Q4AAFIaAAC3BQAAHBEAAIEcAADmBwAASxMAALAeAAAVCgAAehUAAN8AAABEDAAAqRcAAA4DAABzDgAA
| 2BkAAD0FAACiEAAABxwAAGwHAADREgAANh4AAJsJAAAAFQAAZQAAAMoLAAAvFwAAlAIAAPkNAABeGQAAwwQAACgQAACNGwAA
| 8gYAAFcSAAC8HQAAIQkAAIYUAADrHwAAUAsAALUWAAAaAgAAfw0AAOQYAABJBAAArg8AABMbAAB4BgAA3REAAEIdAACnCAAA
| DBQAAHEfAADWCgAAOxYAAKABAAAFDQAAahgAAM8DAAA0DwAAmRoAAP4FAABjEQAAyBwAAC0IAACSEwAA9x4AAFwKAADBFQAA
| JgEAAIsMAADwFwAAVQMAALoOAAAfGgAAhAUAAOkQAABOHAAAswcAABgTAAB9HgAA4gkAAEcVAACsAAAAEQwAAHYXAADbAgAA
| QA4AAKUZAAAKBQAAbxAAANQbAAA5BwAAnhIAAAMeAABoCQAAzRQAADIAAACXCwAA/BYAAGECAADGDQAAKxkAAJAEAAD1DwAA
| WhsAAL8GAAAkEgAAiR0AAO4IAABTFAAAuB8AAB0LAACCFgAA5wEAAEwNAACxGAAAFgQAAHsPAADgGgAARQYAAKoRAAAPHQAA
| dAgAANkTAAA+HwAAowoAAAgWAABtAQAA0gwAADcYAACcAwAAAQ8AAGYaAADLBQAAMBEAAJUcAAD6BwAAXxMAAMQeAAApCgAA
| jhUAAPMAAABYDAAAvRcAACIDAACHDgAA7BkAAFEFAAC2EAAAGxwAAIAHAADlEgAASh4AAK8JAAAUFQAAeQAAAN4LAABDFwAA
| qAIAAA0OAAByGQAA1wQAADwQAAChGwAABgcAAGsSAADQHQAANQkAAJoUAAD/HwAAZAsAAMkWAAAuAgAAkw0AAPgYAABdBAAA
| wg8AACcbAACMBgAA8REAAFYdAAC7CAAAIBQAAIUfAADqCgAATxYAALQBAAAZDQAAfhgAAOMDAABIDwAArRoAABIGAAB3EQAA
| IQkAAIYUAADrHwAAUAsAALUWAAAaAgAAfw0AAOQYAABJBAAArg8AABMbAAB4BgAA3REAAEIdAACnCAAADBQAAHEfAADWCgAA
| OxYAAKABAAAFDQAAahgAAM8DAAA0DwAAmRoAAP4FAABjEQAAyBwAAC0IAACSEwAA9x4AAFwKAADBFQAAJgEAAIsMAADwFwAA
| VQMAALoOAAAfGgAAhAUAAOkQAABOHAAAswcAABgTAAB9HgAA4gkAAEcVAACsAAAAEQwAAHYXAADbAgAAQA4AAKUZAAAKBQAA
| bxAAANQbAAA5BwAAnhIAAAMeAABoCQAAzRQAADIAAACXCwAA/BYAAGECAADGDQAAKxkAAJAEAAD1DwAAWhsAAL8GAAAkEgAA
| iR0AAO4IAABTFAAAuB8AAB0LAACCFgAA5wEAAEwNAACxGAAAFgQAAHsPAADgGgAARQYAAKoRAAAPHQAAdAgAANkTAAA+HwAA
| owoAAAgWAABtAQAA0gwAADcYAACcAwAAAQ8AAGYaAADLBQAAMBEAAJUcAAD6BwAAXxMAAMQeAAApCgAAjhUAAPMAAABYDAAA
| vRcAACIDAACHDgAA7BkAAFEFAAC2EAAAGxwAAIAHAADlEgAASh4AAK8JAAAUFQAAeQAAAN4LAABDFwAAqAIAAA0OAAByGQAA
| 1wQAADwQAAChGwAABgcAAGsSAADQHQAANQkAAJoUAAD/HwAAZAsAAMkWAAAuAgAAkw0AAPgYAABdBAAAwg8AACcbAACMBgAA
| 8REAAFYdAAC7CAAAIBQAAIUfAADqCgAATxYAALQBAAAZDQAAfhgAAOMDAABIDwAArRoAABIGAAB3EQAA3BwAAEEIAACmEwAA
| Cx8AAHAKAADVFQAAOgEAAJ8MAAAEGAAAaQMAAM4OAAAzGgAAmAUAAP0QAABiHAAAxwcAACwTAACRHgAA9gkAAFsVAADAAAAA
| JQwAAIoXAADvAgAAVA4AALkZAAAeBQAAgxAAAOgbAABNBwAAshIAABceAAB8CQAA4RQAAEYAAACrCwAAEBcAAHUCAADaDQAA
| PxkAAKQEAAAJEAAAbhsAANMGAAA4EgAAnR0AAAIJAABnFAAAzB8AADELAACWFgAA+wEAAGANAADFGAAAKgQAAI8PAAD0GgAA
| WQYAAL4RAAAjHQAAiAgAAO0TAABSHwAAtwoAABwWAACBAQAA5gwAAEsYAACwAwAAFQ8AAHoaAADfBQAARBEAAKkcAAAOCAAA
| cxMAANgeAAA9CgAAohUAAAcBAABsDAAA0RcAADYDAACbDgAAABoAAGUFAADKEAAALxwAAJQHAAD5EgAAXh4AAMMJAAAoFQAA
| jQAAAPILAABXFwAAvAIAAGYaAADLBQAAMBEAAJUcAAD6BwAAXxMAAMQeAAApCgAAjhUAAPMAAABYDAAAvRcAACIDAACHDgAA
| 7BkAAFEFAAC2EAAAGxwAAIAHAADlEgAASh4AAK8JAAAUFQAAeQAAAN4LAABDFwAAqAIAAA0OAAByGQAA1wQAADwQAAChGwAA
| BgcAAGsSAADQHQAANQkAAJoUAAD/HwAAZAsAAMkWAAAuAgAAkw0AAPgYAABdBAAAwg8AACcbAACMBgAA8REAAFYdAAC7CAAA
| IBQAAIUfAADqCgAATxYAALQBAAAZDQAAfhgAAOMDAABIDwAArRoAABIGAAB3EQAA3BwAAEEIAACmEwAACx8AAHAKAADVFQAA
| OgEAAJ8MAAAEGAAAaQMAAM4OAAAzGgAAmAUAAP0QAABiHAAAxwcAACwTAACRHgAA9gkAAFsVAADAAAAAJQwAAIoXAADvAgAA
| VA4AALkZAAAeBQAAgxAAAOgbAABNBwAAshIAABceAAB8CQAA4RQAAEYAAACrCwAAEBcAAHUCAADaDQAAPxkAAKQEAAAJEAAA
| bhsAANMGAAA4EgAAnR0AAAIJAABnFAAAzB8AADELAACWFgAA+wEAAGANAADFGAAAKgQAAI8PAAD0GgAAWQYAAL4RAAAjHQAA
| iAgAAO0TAABSHwAAtwoAABwWAACBAQAA5gwAAEsYAACwAwAAFQ8AAHoaAADfBQAARBEAAKkcAAAOCAAAcxMAANgeAAA9CgAA
| ohUAAAcBAABsDAAA0RcAADYDAACbDgAAABoAAGUFAADKEAAALxwAAJQHAAD5EgAAXh4AAMMJAAAoFQAAjQAAAPILAABXFwAA
| vAIAACEOAACGGQAA6wQAAFAQAAC1GwAAGgcAAH8SAADkHQAASQkAAK4UAAATAAAAeAsAAN0WAABCAgAApw0AAAwZAABxBAAA
| 1g8AADsbAACgBgAABRIAAGodAADPCAAANBQAAJkfAAD+CgAAYxYAAMgBAAAtDQAAkhgAAPcDAABcDwAAwRoAACYGAACLEQAA
| 8BwAAFUIAAC6EwAAHx8AAIQKAADpFQAATgEAALMMAAAYGAAAfQMAAOIOAABHGgAArAUAABERAAB2HAAA2wcAAEATAAClHgAA
| CgoAAG8VAADUAAAAOQwAAJ4XAAADAwAAaA4AAM0ZAAAyBQAAlxAAAPwbAABhBwAAxhIAACseAACQCQAA9RQAAFoAAAC/CwAA
| JBcAAIkCAADuDQAAUxkAALgEAAAdEAAAghsAAOcGAABMEgAAsR0AABYJAAB7FAAA4B8AAEULAACqFgAADwIAAHQNAADZGAAA
| PgQAAKMPAAAIGwAAbQYAANIRAAA3HQAAnAgAAAEUAACrCwAAEBcAAHUCAADaDQAAPxkAAKQEAAAJEAAAbhsAANMGAAA4EgAA
| nR0AAAIJAABnFAAAzB8AADELAACWFgAA+wEAAGANAADFGAAAKgQAAI8PAAD0GgAAWQYAAL4RAAAjHQAAiAgAAO0TAABSHwAA
| twoAABwWAACBAQAA5gwAAEsYAACwAwAAFQ8AAHoaAADfBQAARBEAAKkcAAAOCAAAcxMAANgeAAA9CgAAohUAAAcBAABsDAAA
| 0RcAADYDAACbDgAAABoAAGUFAADKEAAALxwAAJQHAAD5EgAAXh4AAMMJAAAoFQAAjQAAAPILAABXFwAAvAIAACEOAACGGQAA
| 6wQAAFAQAAC1GwAAGgcAAH8SAADkHQAASQkAAK4UAAATAAAAeAsAAN0WAABCAgAApw0AAAwZAABxBAAA1g8AADsbAACgBgAA
| BRIAAGodAADPCAAANBQAAJkfAAD+CgAAYxYAAMgBAAAtDQAAkhgAAPcDAABcDwAAwRoAACYGAACLEQAA8BwAAFUIAAC6EwAA
| Hx8AAIQKAADpFQAATgEAALMMAAAYGAAAfQMAAOIOAABHGgAArAUAABERAAB2HAAA2wcAAEATAAClHgAACgoAAG8VAADUAAAA
| OQwAAJ4XAAADAwAAaA4AAM0ZAAAyBQAAlxAAAPwbAABhBwAAxhIAACseAACQCQAA9RQAAFoAAAC/CwAAJBcAAIkCAADuDQAA
| UxkAALgEAAAdEAAAghsAAOcGAABMEgAAsR0AABYJAAB7FAAA4B8AAEULAACqFgAADwIAAHQNAADZGAAAPgQAAKMPAAAIGwAA
| bQYAANIRAAA3HQAAnAgAAAEUAABmHwAAywoAADAWAACVAQAA+gwAAF8YAADEAwAAKQ8AAI4aAADzBQAAWBEAAL0cAAAiCAAA
| hxMAAOweAABRCgAAthUAABsBAACADAAA5RcAAEoDAACvDgAAFBoAAHkFAADeEAAAQxwAAKgHAAANEwAAch4AANcJAAA8FQAA
| oQAAAAYMAABrFwAA0AIAADUOAACaGQAA/wQAAGQQAADJGwAALgcAAJMSAAD4HQAAXQkAAMIUAAAnAAAAjAsAAPEWAABWAgAA
| uw0AACAZAACFBAAA6g8AAE8bAAC0BgAAGRIAAH4dAADjCAAASBQAAK0fAAASCwAAdxYAANwBAABBDQAAphgAAAsEAABwDwAA
| 1RoAADoGAACfEQAABB0AAGkIAADOEwAAMx8AAJgKAAD9FQAAYgEAAMcMAAAsGAAAkQMAAPYOAABbGgAAwAUAACURAACKHAAA
| 7wcAAFQTAAC5HgAAHgoAAIMVAADoAAAATQwAALIXAAAXAwAAfA4AAOEZAABGBQAA8BwAAFUIAAC6EwAAHx8AAIQKAADpFQAA
| TgEAALMMAAAYGAAAfQMAAOIOAABHGgAArAUAABERAAB2HAAA2wcAAEATAAClHgAACgoAAG8VAADUAAAAOQwAAJ4XAAADAwAA
| aA4AAM0ZAAAyBQAAlxAAAPwbAABhBwAAxhIAACseAACQCQAA9RQAAFoAAAC/CwAAJBcAAIkCAADuDQAAUxkAALgEAAAdEAAA
| ghsAAOcGAABMEgAAsR0AABYJAAB7FAAA4B8AAEULAACqFgAADwIAAHQNAADZGAAAPgQAAKMPAAAIGwAAbQYAANIRAAA3HQAA
| nAgAAAEUAABmHwAAywoAADAWAACVAQAA+gwAAF8YAADEAwAAKQ8AAI4aAADzBQAAWBEAAL0cAAAiCAAAhxMAAOweAABRCgAA
| thUAABsBAACADAAA5RcAAEoDAACvDgAAFBoAAHkFAADeEAAAQxwAAKgHAAANEwAAch4AANcJAAA8FQAAoQAAAAYMAABrFwAA
| 0AIAADUOAACaGQAA/wQAAGQQAADJGwAALgcAAJMSAAD4HQAAXQkAAMIUAAAnAAAAjAsAAPEWAABWAgAAuw0AACAZAACFBAAA
| 6g8AAE8bAAC0BgAAGRIAAH4dAADjCAAASBQAAK0fAAASCwAAdxYAANwBAABBDQAAphgAAAsEAABwDwAA1RoAADoGAACfEQAA
| BB0AAGkIAADOEwAAMx8AAJgKAAD9FQAAYgEAAMcMAAAsGAAAkQMAAPYOAABbGgAAwAUAACURAACKHAAA7wcAAFQTAAC5HgAA
| HgoAAIMVAADoAAAATQwAALIXAAAXAwAAfA4AAOEZAABGBQAAqxAAABAcAAB1BwAA2hIAAD8eAACkCQAACRUAAG4AAADTCwAA
| OBcAAJ0CAAACDgAAZxkAAMwEAAAxEAAAlhsAAPsGAABgEgAAxR0AACoJAACPFAAA9B8AAFkLAAC+FgAAIwIAAIgNAADtGAAA
| UgQAALcPAAAcGwAAgQYAAOYRAABLHQAAsAgAABUUAAB6HwAA3woAAEQWAACpAQAADg0AAHMYAADYAwAAPQ8AAKIaAAAHBgAA
| bBEAANEcAAA2CAAAmxMAAAAfAABlCgAAyhUAAC8BAACUDAAA+RcAAF4DAADDDgAAKBoAAI0FAADyEAAAVxwAALwHAAAhEwAA
| hh4AAOsJAABQFQAAtQAAABoMAAB/FwAA5AIAAEkOAACuGQAAEwUAAHgQAADdGwAAQgcAAKcSAAAMHgAAcQkAANYUAAA7AAAA
| oAsAAAUXAABqAgAAzw0AADQZAACZBAAA/g8AAGMbAADIBgAALRIAAJIdAAD3CAAAXBQAAMEfAAAmCwAAixYAADUOAACaGQAA
| /wQAAGQQAADJGwAALgcAAJMSAAD4HQAAXQkAAMIUAAAnAAAAjAsAAPEWAABWAgAAuw0AACAZAACFBAAA6g8AAE8bAAC0BgAA
| GRIAAH4dAADjCAAASBQAAK0fAAASCwAAdxYAANwBAABBDQAAphgAAAsEAABwDwAA1RoAADoGAACfEQAABB0AAGkIAADOEwAA
| Mx8AAJgKAAD9FQAAYgEAAMcMAAAsGAAAkQMAAPYOAABbGgAAwAUAACURAACKHAAA7wcAAFQTAAC5HgAAHgoAAIMVAADoAAAA
| TQwAALIXAAAXAwAAfA4AAOEZAABGBQAAqxAAABAcAAB1BwAA2hIAAD8eAACkCQAACRUAAG4AAADTCwAAOBcAAJ0CAAACDgAA
| ZxkAAMwEAAAxEAAAlhsAAPsGAABgEgAAxR0AACoJAACPFAAA9B8AAFkLAAC+FgAAIwIAAIgNAADtGAAAUgQAALcPAAAcGwAA
| gQYAAOYRAABLHQAAsAgAABUUAAB6HwAA3woAAEQWAACpAQAADg0AAHMYAADYAwAAPQ8AAKIaAAAHBgAAbBEAANEcAAA2CAAA
| mxMAAAAfAABlCgAAyhUAAC8BAACUDAAA+RcAAF4DAADDDgAAKBoAAI0FAADyEAAAVxwAALwHAAAhEwAAhh4AAOsJAABQFQAA
| tQAAABoMAAB/FwAA5AIAAEkOAACuGQAAEwUAAHgQAADdGwAAQgcAAKcSAAAMHgAAcQkAANYUAAA7AAAAoAsAAAUXAABqAgAA
| zw0AADQZAACZBAAA/g8AAGMbAADIBgAALRIAAJIdAAD3CAAAXBQAAMEfAAAmCwAAixYAAPABAABVDQAAuhgAAB8EAACEDwAA
| 6RoAAE4GAACzEQAAGB0AAH0IAADiEwAARx8AAKwKAAARFgAAdgEAANsMAABAGAAApQMAAAoPAABvGgAA1AUAADkRAACeHAAA
| AwgAAGgTAADNHgAAMgoAAJcVAAD8AAAAYQwAAMYXAAArAwAAkA4AAPUZAABaBQAAvxAAACQcAACJBwAA7hIAAFMeAAC4CQAA
| HRUAAIIAAADnCwAATBcAALECAAAWDgAAexkAAOAEAABFEAAAqhsAAA8HAAB0EgAA2R0AAD4JAACjFAAACAAAAG0LAADSFgAA
| NwIAAJwNAAABGQAAZgQAAMsPAAAwGwAAlQYAAPoRAABfHQAAxAgAACkUAACOHwAA8woAAFgWAAC9AQAAIg0AAIcYAADsAwAA
| UQ8AALYaAAAbBgAAgBEAAOUcAABKCAAArxMAABQfAAB5CgAA3hUAAEMBAACoDAAADRgAAHIDAADXDgAAPBoAAKEFAAAGEQAA
| axwAANAHAAB6HwAA3woAAEQWAACpAQAADg0AAHMYAADYAwAAPQ8AAKIaAAAHBgAAbBEAANEcAAA2CAAAmxMAAAAfAABlCgAA
| yhUAAC8BAACUDAAA+RcAAF4DAADDDgAAKBoAAI0FAADyEAAAVxwAALwHAAAhEwAAhh4AAOsJAABQFQAAtQAAABoMAAB/FwAA
| 5AIAAEkOAACuGQAAEwUAAHgQAADdGwAAQgcAAKcSAAAMHgAAcQkAANYUAAA7AAAAoAsAAAUXAABqAgAAzw0AADQZAACZBAAA
| /g8AAGMbAADIBgAALRIAAJIdAAD3CAAAXBQAAMEfAAAmCwAAixYAAPABAABVDQAAuhgAAB8EAACEDwAA6RoAAE4GAACzEQAA
| GB0AAH0IAADiEwAARx8AAKwKAAARFgAAdgEAANsMAABAGAAApQMAAAoPAABvGgAA1AUAADkRAACeHAAAAwgAAGgTAADNHgAA
| MgoAAJcVAAD8AAAAYQwAAMYXAAArAwAAkA4AAPUZAABaBQAAvxAAACQcAACJBwAA7hIAAFMeAAC4CQAAHRUAAIIAAADnCwAA
| TBcAALECAAAWDgAAexkAAOAEAABFEAAAqhsAAA8HAAB0EgAA2R0AAD4JAACjFAAACAAAAG0LAADSFgAANwIAAJwNAAABGQAA
| ZgQAAMsPAAAwGwAAlQYAAPoRAABfHQAAxAgAACkUAACOHwAA8woAAFgWAAC9AQAAIg0AAIcYAADsAwAAUQ8AALYaAAAbBgAA
| gBEAAOUcAABKCAAArxMAABQfAAB5CgAA3hUAAEMBAACoDAAADRgAAHIDAADXDgAAPBoAAKEFAAAGEQAAaxwAANAHAAA1EwAA
| mh4AAP8JAABkFQAAyQAAAC4MAACTFwAA+AIAAF0OAADCGQAAJwUAAIwQAADxGwAAVgcAALsSAAAgHgAAhQkAAOoUAABPAAAA
| tAsAABkXAAB+AgAA4w0AAEgZAACtBAAAEhAAAHcbAADcBgAAQRIAAKYdAAALCQAAcBQAANUfAAA6CwAAnxYAAAQCAABpDQAA
| zhgAADMEAACYDwAA/RoAAGIGAADHEQAALB0AAJEIAAD2EwAAWx8AAMAKAAAlFgAAigEAAO8MAABUGAAAuQMAAB4PAACDGgAA
| 6AUAAE0RAACyHAAAFwgAAHwTAADhHgAARgoAAKsVAAAQAQAAdQwAANoXAAA/AwAApA4AAAkaAABuBQAA0xAAADgcAACdBwAA
| AhMAAGceAADMCQAAMRUAAJYAAAD7CwAAYBcAAMUCAAAqDgAAjxkAAPQEAABZEAAAvhsAACMHAACIEgAA7R0AAFIJAAC3FAAA
| HAAAAIELAADmFgAASwIAALANAAAVGQAAvxAAACQcAACJBwAA7hIAAFMeAAC4CQAAHRUAAIIAAADnCwAATBcAALECAAAWDgAA
| exkAAOAEAABFEAAAqhsAAA8HAAB0EgAA2R0AAD4JAACjFAAACAAAAG0LAADSFgAANwIAAJwNAAABGQAAZgQAAMsPAAAwGwAA
| lQYAAPoRAABfHQAAxAgAACkUAACOHwAA8woAAFgWAAC9AQAAIg0AAIcYAADsAwAAUQ8AALYaAAAbBgAAgBEAAOUcAABKCAAA
| rxMAABQfAAB5CgAA3hUAAEMBAACoDAAADRgAAHIDAADXDgAAPBoAAKEFAAAGEQAAaxwAANAHAAA1EwAAmh4AAP8JAABkFQAA
| yQAAAC4MAACTFwAA+AIAAF0OAADCGQAAJwUAAIwQAADxGwAAVgcAALsSAAAgHgAAhQkAAOoUAABPAAAAtAsAABkXAAB+AgAA
| 4w0AAEgZAACtBAAAEhAAAHcbAADcBgAAQRIAAKYdAAALCQAAcBQAANUfAAA6CwAAnxYAAAQCAABpDQAAzhgAADMEAACYDwAA
| /RoAAGIGAADHEQAALB0AAJEIAAD2EwAAWx8AAMAKAAAlFgAAigEAAO8MAABUGAAAuQMAAB4PAACDGgAA6AUAAE0RAACyHAAA
| FwgAAHwTAADhHgAARgoAAKsVAAAQAQAAdQwAANoXAAA/AwAApA4AAAkaAABuBQAA0xAAADgcAACdBwAAAhMAAGceAADMCQAA
| MRUAAJYAAAD7CwAAYBcAAMUCAAAqDgAAjxkAAPQEAABZEAAAvhsAACMHAACIEgAA7R0AAFIJAAC3FAAAHAAAAIELAADmFgAA
| SwIAALANAAAVGQAAegQAAN8PAABEGwAAqQYAAA4SAABzHQAA2AgAAD0UAACiHwAABwsAAGwWAADRAQAANg0AAJsYAAAABAAA
| ZQ8AAMoaAAAvBgAAlBEAAPkcAABeCAAAwxMAACgfAACNCgAA8hUAAFcBAAC8DAAAIRgAAIYDAADrDgAAUBoAALUFAAAaEQAA
| fxwAAOQHAABJEwAArh4AABMKAAB4FQAA3QAAAEIMAACnFwAADAMAAHEOAADWGQAAOwUAAKAQAAAFHAAAagcAAM8SAAA0HgAA
| mQkAAP4UAABjAAAAyAsAAC0XAACSAgAA9w0AAFwZAADBBAAAJhAAAIsbAADwBgAAVRIAALodAAAfCQAAhBQAAOkfAABOCwAA
| sxYAABgCAAB9DQAA4hgAAEcEAACsDwAAERsAAHYGAADbEQAAQB0AAKUIAAAKFAAAbx8AANQKAAA5FgAAngEAAAMNAABoGAAA
| zQMAADIPAACXGgAA/AUAAGERAADGHAAAKwgAAJATAAD1HgAAWgoAAAQCAABpDQAAzhgAADMEAACYDwAA/RoAAGIGAADHEQAA
| LB0AAJEIAAD2EwAAWx8AAMAKAAAlFgAAigEAAO8MAABUGAAAuQMAAB4PAACDGgAA6AUAAE0RAACyHAAAFwgAAHwTAADhHgAA
| RgoAAKsVAAAQAQAAdQwAANoXAAA/AwAApA4AAAkaAABuBQAA0xAAADgcAACdBwAAAhMAAGceAADMCQAAMRUAAJYAAAD7CwAA
| YBcAAMUCAAAqDgAAjxkAAPQEAABZEAAAvhsAACMHAACIEgAA7R0AAFIJAAC3FAAAHAAAAIELAADmFgAASwIAALANAAAVGQAA
| egQAAN8PAABEGwAAqQYAAA4SAABzHQAA2AgAAD0UAACiHwAABwsAAGwWAADRAQAANg0AAJsYAAAABAAAZQ8AAMoaAAAvBgAA
| lBEAAPkcAABeCAAAwxMAACgfAACNCgAA8hUAAFcBAAC8DAAAIRgAAIYDAADrDgAAUBoAALUFAAAaEQAAfxwAAOQHAABJEwAA
| rh4AABMKAAB4FQAA3QAAAEIMAACnFwAADAMAAHEOAADWGQAAOwUAAKAQAAAFHAAAagcAAM8SAAA0HgAAmQkAAP4UAABjAAAA
| yAsAAC0XAACSAgAA9w0AAFwZAADBBAAAJhAAAIsbAADwBgAAVRIAALodAAAfCQAAhBQAAOkfAABOCwAAsxYAABgCAAB9DQAA
| 4hgAAEcEAACsDwAAERsAAHYGAADbEQAAQB0AAKUIAAAKFAAAbx8AANQKAAA5FgAAngEAAAMNAABoGAAAzQMAADIPAACXGgAA
| /AUAAGERAADGHAAAKwgAAJATAAD1HgAAWgoAAL8VAAAkAQAAiQwAAO4XAABTAwAAuA4AAB0aAACCBQAA5xAAAEwcAACxBwAA
| FhMAAHseAADgCQAARRUAAKoAAAAPDAAAdBcAANkCAAA+DgAAoxkAAAgFAABtEAAA0hsAADcHAACcEgAAAR4AAGYJAADLFAAA
| MAAAAJULAAD6FgAAXwIAAMQNAAApGQAAjgQAAPMPAABYGwAAvQYAACISAACHHQAA7AgAAFEUAAC2HwAAGwsAAIAWAADlAQAA
| Sg0AAK8YAAAUBAAAeQ8AAN4aAABDBgAAqBEAAA0dAAByCAAA1xMAADwfAAChCgAABhYAAGsBAADQDAAANRgAAJoDAAD/DgAA
| ZBoAAMkFAAAuEQAAkxwAAPgHAABdEwAAwh4AACcKAACMFQAA8QAAAFYMAAC7FwAAIAMAAIUOAADqGQAATwUAALQQAAAZHAAA
| fgcAAOMSAABIHgAArQkAABIVAAB3AAAA3AsAAEEXAACmAgAACw4AAHAZAADVBAAAOhAAAJ8bAABJEwAArh4AABMKAAB4FQAA
| 3QAAAEIMAACnFwAADAMAAHEOAADWGQAAOwUAAKAQAAAFHAAAagcAAM8SAAA0HgAAmQkAAP4UAABjAAAAyAsAAC0XAACSAgAA
| 9w0AAFwZAADBBAAAJhAAAIsbAADwBgAAVRIAALodAAAfCQAAhBQAAOkfAABOCwAAsxYAABgCAAB9DQAA4hgAAEcEAACsDwAA
| ERsAAHYGAADbEQAAQB0AAKUIAAAKFAAAbx8AANQKAAA5FgAAngEAAAMNAABoGAAAzQMAADIPAACXGgAA/AUAAGERAADGHAAA
| KwgAAJATAAD1HgAAWgoAAL8VAAAkAQAAiQwAAO4XAABTAwAAuA4AAB0aAACCBQAA5xAAAEwcAACxBwAAFhMAAHseAADgCQAA
| RRUAAKoAAAAPDAAAdBcAANkCAAA+DgAAoxkAAAgFAABtEAAA0hsAADcHAACcEgAAAR4AAGYJAADLFAAAMAAAAJULAAD6FgAA
| XwIAAMQNAAApGQAAjgQAAPMPAABYGwAAvQYAACISAACHHQAA7AgAAFEUAAC2HwAAGwsAAIAWAADlAQAASg0AAK8YAAAUBAAA
| eQ8AAN4aAABDBgAAqBEAAA0dAAByCAAA1xMAADwfAAChCgAABhYAAGsBAADQDAAANRgAAJoDAAD/DgAAZBoAAMkFAAAuEQAA
| kxwAAPgHAABdEwAAwh4AACcKAACMFQAA8QAAAFYMAAC7FwAAIAMAAIUOAADqGQAATwUAALQQAAAZHAAAfgcAAOMSAABIHgAA
| rQkAABIVAAB3AAAA3AsAAEEXAACmAgAACw4AAHAZAADVBAAAOhAAAJ8bAAAEBwAAaRIAAM4dAAAzCQAAmBQAAP0fAABiCwAA
| xxYAACwCAACRDQAA9hgAAFsEAADADwAAJRsAAIoGAADvEQAAVB0AALkIAAAeFAAAgx8AAOgKAABNFgAAsgEAABcNAAB8GAAA
| 4QMAAEYPAACrGgAAEAYAAHURAADaHAAAPwgAAKQTAAAJHwAAbgoAANMVAAA4AQAAnQwAAAIYAABnAwAAzA4AADEaAACWBQAA
| +xAAAGAcAADFBwAAKhMAAI8eAAD0CQAAWRUAAL4AAAAjDAAAiBcAAO0CAABSDgAAtxkAABwFAACBEAAA5hsAAEsHAACwEgAA
| FR4AAHoJAADfFAAARAAAAKkLAAAOFwAAcwIAANgNAAA9GQAAogQAAAcQAABsGwAA0QYAADYSAACbHQAAAAkAAGUUAADKHwAA
| LwsAAJQWAAD5AQAAXg0AAMMYAAAoBAAAjQ8AAPIaAABXBgAAvBEAACEdAACGCAAA6xMAAFAfAAC1CgAAGhYAAH8BAADkDAAA
| jgQAAPMPAABYGwAAvQYAACISAACHHQAA7AgAAFEUAAC2HwAAGwsAAIAWAADlAQAASg0AAK8YAAAUBAAAeQ8AAN4aAABDBgAA
| qBEAAA0dAAByCAAA1xMAADwfAAChCgAABhYAAGsBAADQDAAANRgAAJoDAAD/DgAAZBoAAMkFAAAuEQAAkxwAAPgHAABdEwAA
| wh4AACcKAACMFQAA8QAAAFYMAAC7FwAAIAMAAIUOAADqGQAATwUAALQQAAAZHAAAfgcAAOMSAABIHgAArQkAABIVAAB3AAAA
| 3AsAAEEXAACmAgAACw4AAHAZAADVBAAAOhAAAJ8bAAAEBwAAaRIAAM4dAAAzCQAAmBQAAP0fAABiCwAAxxYAACwCAACRDQAA
| 9hgAAFsEAADADwAAJRsAAIoGAADvEQAAVB0AALkIAAAeFAAAgx8AAOgKAABNFgAAsgEAABcNAAB8GAAA4QMAAEYPAACrGgAA
| EAYAAHURAADaHAAAPwgAAKQTAAAJHwAAbgoAANMVAAA4AQAAnQwAAAIYAABnAwAAzA4AADEaAACWBQAA+xAAAGAcAADFBwAA
| KhMAAI8eAAD0CQAAWRUAAL4AAAAjDAAAiBcAAO0CAABSDgAAtxkAABwFAACBEAAA5hsAAEsHAACwEgAAFR4AAHoJAADfFAAA
| RAAAAKkLAAAOFwAAcwIAANgNAAA9GQAAogQAAAcQAABsGwAA0QYAADYSAACbHQAAAAkAAGUUAADKHwAALwsAAJQWAAD5AQAA
| Xg0AAMMYAAAoBAAAjQ8AAPIaAABXBgAAvBEAACEdAACGCAAA6xMAAFAfAAC1CgAAGhYAAH8BAADkDAAASRgAAK4DAAATDwAA
| eBoAAN0FAABCEQAApxwAAAwIAABxEwAA1h4AADsKAACgFQAABQEAAGoMAADPFwAANAMAAJkOAAD+GQAAYwUAAMgQAAAtHAAA
| kgcAAPcSAABcHgAAwQkAACYVAACLAAAA8AsAAFUXAAC6AgAAHw4AAIQZAADpBAAAThAAALMbAAAYBwAAfRIAAOIdAABHCQAA
| rBQAABEAAAB2CwAA2xYAAEACAAClDQAAChkAAG8EAADUDwAAORsAAJ4GAAADEgAAaB0AAM0IAAAyFAAAlx8AAPwKAABhFgAA
| xgEAACsNAACQGAAA9QMAAFoPAAC/GgAAJAYAAIkRAADuHAAAUwgAALgTAAAdHwAAggoAAOcVAABMAQAAsQwAABYYAAB7AwAA
| 4A4AAEUaAACqBQAADxEAAHQcAADZBwAAPhMAAKMeAAAICgAAbRUAANIAAAA3DAAAnBcAAAEDAABmDgAAyxkAADAFAACVEAAA
| +hsAAF8HAADEEgAAKR4AANMVAAA4AQAAnQwAAAIYAABnAwAAzA4AADEaAACWBQAA+xAAAGAcAADFBwAAKhMAAI8eAAD0CQAA
| WRUAAL4AAAAjDAAAiBcAAO0CAABSDgAAtxkAABwFAACBEAAA5hsAAEsHAACwEgAAFR4AAHoJAADfFAAARAAAAKkLAAAOFwAA
| cwIAANgNAAA9GQAAogQAAAcQAABsGwAA0QYAADYSAACbHQAAAAkAAGUUAADKHwAALwsAAJQWAAD5AQAAXg0AAMMYAAAoBAAA
| jQ8AAPIaAABXBgAAvBEAACEdAACGCAAA6xMAAFAfAAC1CgAAGhYAAH8BAADkDAAASRgAAK4DAAATDwAAeBoAAN0FAABCEQAA
| pxwAAAwIAABxEwAA1h4AADsKAACgFQAABQEAAGoMAADPFwAANAMAAJkOAAD+GQAAYwUAAMgQAAAtHAAAkgcAAPcSAABcHgAA
| wQkAACYVAACLAAAA8AsAAFUXAAC6AgAAHw4AAIQZAADpBAAAThAAALMbAAAYBwAAfRIAAOIdAABHCQAArBQAABEAAAB2CwAA
| 2xYAAEACAAClDQAAChkAAG8EAADUDwAAORsAAJ4GAAADEgAAaB0AAM0IAAAyFAAAlx8AAPwKAABhFgAAxgEAACsNAACQGAAA
| 9QMAAFoPAAC/GgAAJAYAAIkRAADuHAAAUwgAALgTAAAdHwAAggoAAOcVAABMAQAAsQwAABYYAAB7AwAA4A4AAEUaAACqBQAA
| DxEAAHQcAADZBwAAPhMAAKMeAAAICgAAbRUAANIAAAA3DAAAnBcAAAEDAABmDgAAyxkAADAFAACVEAAA+hsAAF8HAADEEgAA
| KR4AAI4JAADzFAAAWAAAAL0LAAAiFwAAhwIAAOwNAABRGQAAtgQAABsQAACAGwAA5QYAAEoSAACvHQAAFAkAAHkUAADeHwAA
| QwsAAKgWAAANAgAAcg0AANcYAAA8BAAAoQ8AAAYbAABrBgAA0BEAADUdAACaCAAA/xMAAGQfAADJCgAALhYAAJMBAAD4DAAA
| XRgAAMIDAAAnDwAAjBoAAPEFAABWEQAAuxwAACAIAACFEwAA6h4AAE8KAAC0FQAAGQEAAH4MAADjFwAASAMAAK0OAAASGgAA
| dwUAANwQAABBHAAApgcAAAsTAABwHgAA1QkAADoVAACfAAAABAwAAGkXAADOAgAAMw4AAJgZAAD9BAAAYhAAAMcbAAAsBwAA
| kRIAAPYdAABbCQAAwBQAACUAAACKCwAA7xYAAFQCAAC5DQAAHhkAAIMEAADoDwAATRsAALIGAAAXEgAAfB0AAOEIAABGFAAA
| qx8AABALAAB1FgAA2gEAAD8NAACkGAAACQQAAG4PAAAYBwAAfRIAAOIdAABHCQAArBQAABEAAAB2CwAA2xYAAEACAAClDQAA
| ChkAAG8EAADUDwAAORsAAJ4GAAADEgAAaB0AAM0IAAAyFAAAlx8AAPwKAABhFgAAxgEAACsNAACQGAAA9QMAAFoPAAC/GgAA
| JAYAAIkRAADuHAAAUwgAALgTAAAdHwAAggoAAOcVAABMAQAAsQwAABYYAAB7AwAA4A4AAEUaAACqBQAADxEAAHQcAADZBwAA
| PhMAAKMeAAAICgAAbRUAANIAAAA3DAAAnBcAAAEDAABmDgAAyxkAADAFAACVEAAA+hsAAF8HAADEEgAAKR4AAI4JAADzFAAA
| WAAAAL0LAAAiFwAAhwIAAOwNAABRGQAAtgQAABsQAACAGwAA5QYAAEoSAACvHQAAFAkAAHkUAADeHwAAQwsAAKgWAAANAgAA
| cg0AANcYAAA8BAAAoQ8AAAYbAABrBgAA0BEAADUdAACaCAAA/xMAAGQfAADJCgAALhYAAJMBAAD4DAAAXRgAAMIDAAAnDwAA
| jBoAAPEFAABWEQAAuxwAACAIAACFEwAA6h4AAE8KAAC0FQAAGQEAAH4MAADjFwAASAMAAK0OAAASGgAAdwUAANwQAABBHAAA
| pgcAAAsTAABwHgAA1QkAADoVAACfAAAABAwAAGkXAADOAgAAMw4AAJgZAAD9BAAAYhAAAMcbAAAsBwAAkRIAAPYdAABbCQAA
| wBQAACUAAACKCwAA7xYAAFQCAAC5DQAAHhkAAIMEAADoDwAATRsAALIGAAAXEgAAfB0AAOEIAABGFAAAqx8AABALAAB1FgAA
| 2gEAAD8NAACkGAAACQQAAG4PAADTGgAAOAYAAJ0RAAACHQAAZwgAAMwTAAAxHwAAlgoAAPsVAABgAQAAxQwAACoYAACPAwAA
| 9A4AAFkaAAC+BQAAIxEAAIgcAADtBwAAUhMAALceAAAcCgAAgRUAAOYAAABLDAAAsBcAABUDAAB6DgAA3xkAAEQFAACpEAAA
| DhwAAHMHAADYEgAAPR4AAKIJAAAHFQAAbAAAANELAAA2FwAAmwIAAAAOAABlGQAAygQAAC8QAACUGwAA+QYAAF4SAADDHQAA
| KAkAAI0UAADyHwAAVwsAALwWAAAhAgAAhg0AAOsYAABQBAAAtQ8AABobAAB/BgAA5BEAAEkdAACuCAAAExQAAHgfAADdCgAA
| QhYAAKcBAAAMDQAAcRgAANYDAAA7DwAAoBoAAAUGAABqEQAAzxwAADQIAACZEwAA/h4AAGMKAADIFQAALQEAAJIMAAD3FwAA
| XAMAAMEOAAAmGgAAiwUAAPAQAABVHAAAugcAAB8TAACEHgAA6QkAAE4VAACzAAAAXRgAAMIDAAAnDwAAjBoAAPEFAABWEQAA
| uxwAACAIAACFEwAA6h4AAE8KAAC0FQAAGQEAAH4MAADjFwAASAMAAK0OAAASGgAAdwUAANwQAABBHAAApgcAAAsTAABwHgAA
| 1QkAADoVAACfAAAABAwAAGkXAADOAgAAMw4AAJgZAAD9BAAAYhAAAMcbAAAsBwAAkRIAAPYdAABbCQAAwBQAACUAAACKCwAA
| 7xYAAFQCAAC5DQAAHhkAAIMEAADoDwAATRsAALIGAAAXEgAAfB0AAOEIAABGFAAAqx8AABALAAB1FgAA2gEAAD8NAACkGAAA
| CQQAAG4PAADTGgAAOAYAAJ0RAAACHQAAZwgAAMwTAAAxHwAAlgoAAPsVAABgAQAAxQwAACoYAACPAwAA9A4AAFkaAAC+BQAA
| IxEAAIgcAADtBwAAUhMAALceAAAcCgAAgRUAAOYAAABLDAAAsBcAABUDAAB6DgAA3xkAAEQFAACpEAAADhwAAHMHAADYEgAA
| PR4AAKIJAAAHFQAAbAAAANELAAA2FwAAmwIAAAAOAABlGQAAygQAAC8QAACUGwAA+QYAAF4SAADDHQAAKAkAAI0UAADyHwAA
| VwsAALwWAAAhAgAAhg0AAOsYAABQBAAAtQ8AABobAAB/BgAA5BEAAEkdAACuCAAAExQAAHgfAADdCgAAQhYAAKcBAAAMDQAA
| cRgAANYDAAA7DwAAoBoAAAUGAABqEQAAzxwAADQIAACZEwAA/h4AAGMKAADIFQAALQEAAJIMAAD3FwAAXAMAAMEOAAAmGgAA
| iwUAAPAQAABVHAAAugcAAB8TAACEHgAA6QkAAE4VAACzAAAAGAwAAH0XAADiAgAARw4AAKwZAAARBQAAdhAAANsbAABABwAA
| pRIAAAoeAABvCQAA1BQAADkAAACeCwAAAxcAAGgCAADNDQAAMhkAAJcEAAD8DwAAYRsAAMYGAAArEgAAkB0AAPUIAABaFAAA
| vx8AACQLAACJFgAA7gEAAFMNAAC4GAAAHQQAAIIPAADnGgAATAYAALERAAAWHQAAewgAAOATAABFHwAAqgoAAA8WAAB0AQAA
| 2QwAAD4YAACjAwAACA8AAG0aAADSBQAANxEAAJwcAAABCAAAZhMAAMseAAAwCgAAlRUAAPoAAABfDAAAxBcAACkDAACODgAA
| 8xkAAFgFAAC9EAAAIhwAAIcHAADsEgAAUR4AALYJAAAbFQAAgAAAAOULAABKFwAArwIAABQOAAB5GQAA3gQAAEMQAACoGwAA
| DQcAAHISAADXHQAAPAkAAKEUAAAGAAAAawsAANAWAAA1AgAAmg0AAP8YAABkBAAAyQ8AAC4bAACTBgAA+BEAAKIJAAAHFQAA
| bAAAANELAAA2FwAAmwIAAAAOAABlGQAAygQAAC8QAACUGwAA+QYAAF4SAADDHQAAKAkAAI0UAADyHwAAVwsAALwWAAAhAgAA
| hg0AAOsYAABQBAAAtQ8AABobAAB/BgAA5BEAAEkdAACuCAAAExQAAHgfAADdCgAAQhYAAKcBAAAMDQAAcRgAANYDAAA7DwAA
| oBoAAAUGAABqEQAAzxwAADQIAACZEwAA/h4AAGMKAADIFQAALQEAAJIMAAD3FwAAXAMAAMEOAAAmGgAAiwUAAPAQAABVHAAA
| ugcAAB8TAACEHgAA6QkAAE4VAACzAAAAGAwAAH0XAADiAgAARw4AAKwZAAARBQAAdhAAANsbAABABwAApRIAAAoeAABvCQAA
| 1BQAADkAAACeCwAAAxcAAGgCAADNDQAAMhkAAJcEAAD8DwAAYRsAAMYGAAArEgAAkB0AAPUIAABaFAAAvx8AACQLAACJFgAA
| 7gEAAFMNAAC4GAAAHQQAAIIPAADnGgAATAYAALERAAAWHQAAewgAAOATAABFHwAAqgoAAA8WAAB0AQAA2QwAAD4YAACjAwAA
| CA8AAG0aAADSBQAANxEAAJwcAAABCAAAZhMAAMseAAAwCgAAlRUAAPoAAABfDAAAxBcAACkDAACODgAA8xkAAFgFAAC9EAAA
| IhwAAIcHAADsEgAAUR4AALYJAAAbFQAAgAAAAOULAABKFwAArwIAABQOAAB5GQAA3gQAAEMQAACoGwAADQcAAHISAADXHQAA
| PAkAAKEUAAAGAAAAawsAANAWAAA1AgAAmg0AAP8YAABkBAAAyQ8AAC4bAACTBgAA+BEAAF0dAADCCAAAJxQAAIwfAADxCgAA
| VhYAALsBAAAgDQAAhRgAAOoDAABPDwAAtBoAABkGAAB+EQAA4xwAAEgIAACtEwAAEh8AAHcKAADcFQAAQQEAAKYMAAALGAAA
| cAMAANUOAAA6GgAAnwUAAAQRAABpHAAAzgcAADMTAACYHgAA/QkAAGIVAADHAAAALAwAAJEXAAD2AgAAWw4AAMAZAAAlBQAA
| ihAAAO8bAABUBwAAuRIAAB4eAACDCQAA6BQAAE0AAACyCwAAFxcAAHwCAADhDQAARhkAAKsEAAAQEAAAdRsAANoGAAA/EgAA
| pB0AAAkJAABuFAAA0x8AADgLAACdFgAAAgIAAGcNAADMGAAAMQQAAJYPAAD7GgAAYAYAAMURAAAqHQAAjwgAAPQTAABZHwAA
| vgoAACMWAACIAQAA7QwAAFIYAAC3AwAAHA8AAIEaAADmBQAASxEAALAcAAAVCAAAehMAAN8eAABECgAAqRUAAA4BAABzDAAA
| 2BcAAD0DAADnGgAATAYAALERAAAWHQAAewgAAOATAABFHwAAqgoAAA8WAAB0AQAA2QwAAD4YAACjAwAACA8AAG0aAADSBQAA
| NxEAAJwcAAABCAAAZhMAAMseAAAwCgAAlRUAAPoAAABfDAAAxBcAACkDAACODgAA8xkAAFgFAAC9EAAAIhwAAIcHAADsEgAA
| UR4AALYJAAAbFQAAgAAAAOULAABKFwAArwIAABQOAAB5GQAA3gQAAEMQAACoGwAADQcAAHISAADXHQAAPAkAAKEUAAAGAAAA
| awsAANAWAAA1AgAAmg0AAP8YAABkBAAAyQ8AAC4bAACTBgAA+BEAAF0dAADCCAAAJxQAAIwfAADxCgAAVhYAALsBAAAgDQAA
| hRgAAOoDAABPDwAAtBoAABkGAAB+EQAA4xwAAEgIAACtEwAAEh8AAHcKAADcFQAAQQEAAKYMAAALGAAAcAMAANUOAAA6GgAA
| nwUAAAQRAABpHAAAzgcAADMTAACYHgAA/QkAAGIVAADHAAAALAwAAJEXAAD2AgAAWw4AAMAZAAAlBQAAihAAAO8bAABUBwAA
| uRIAAB4eAACDCQAA6BQAAE0AAACyCwAAFxcAAHwCAADhDQAARhkAAKsEAAAQEAAAdRsAANoGAAA/EgAApB0AAAkJAABuFAAA
| 0x8AADgLAACdFgAAAgIAAGcNAADMGAAAMQQAAJYPAAD7GgAAYAYAAMURAAAqHQAAjwgAAPQTAABZHwAAvgoAACMWAACIAQAA
| 7QwAAFIYAAC3AwAAHA8AAIEaAADmBQAASxEAALAcAAAVCAAAehMAAN8eAABECgAAqRUAAA4BAABzDAAA2BcAAD0DAACiDgAA
| BxoAAGwFAADREAAANhwAAJsHAAAAEwAAZR4AAMoJAAAvFQAAlAAAAPkLAABeFwAAwwIAACgOAACNGQAA8gQAAFcQAAC8GwAA
| IQcAAIYSAADrHQAAUAkAALUUAAAaAAAAfwsAAOQWAABJAgAArg0AABMZAAB4BAAA3Q8AAEIbAACnBgAADBIAAHEdAADWCAAA
| OxQAAKAfAAAFCwAAahYAAM8BAAA0DQAAmRgAAP4DAABjDwAAyBoAAC0GAACSEQAA9xwAAFwIAADBEwAAJh8AAIsKAADwFQAA
| VQEAALoMAAAfGAAAhAMAAOkOAABOGgAAswUAABgRAAB9HAAA4gcAAEcTAACsHgAAEQoAAHYVAADbAAAAQAwAAKUXAAAKAwAA
| bw4AANQZAAA5BQAAnhAAAAMcAABoBwAAzRIAADIeAACXCQAA/BQAAGEAAADGCwAAKxcAAJACAAD1DQAAWhkAAL8EAAAkEAAA
| iRsAAO4GAABTEgAAuB0AAB0JAACCFAAALAwAAJEXAAD2AgAAWw4AAMAZAAAlBQAAihAAAO8bAABUBwAAuRIAAB4eAACDCQAA
| 6BQAAE0AAACyCwAAFxcAAHwCAADhDQAARhkAAKsEAAAQEAAAdRsAANoGAAA/EgAApB0AAAkJAABuFAAA0x8AADgLAACdFgAA
| AgIAAGcNAADMGAAAMQQAAJYPAAD7GgAAYAYAAMURAAAqHQAAjwgAAPQTAABZHwAAvgoAACMWAACIAQAA7QwAAFIYAAC3AwAA
| HA8AAIEaAADmBQAASxEAALAcAAAVCAAAehMAAN8eAABECgAAqRUAAA4BAABzDAAA2BcAAD0DAACiDgAABxoAAGwFAADREAAA
| NhwAAJsHAAAAEwAAZR4AAMoJAAAvFQAAlAAAAPkLAABeFwAAwwIAACgOAACNGQAA8gQAAFcQAAC8GwAAIQcAAIYSAADrHQAA
| UAkAALUUAAAaAAAAfwsAAOQWAABJAgAArg0AABMZAAB4BAAA3Q8AAEIbAACnBgAADBIAAHEdAADWCAAAOxQAAKAfAAAFCwAA
| ahYAAM8BAAA0DQAAmRgAAP4DAABjDwAAyBoAAC0GAACSEQAA9xwAAFwIAADBEwAAJh8AAIsKAADwFQAAVQEAALoMAAAfGAAA
| hAMAAOkOAABOGgAAswUAABgRAAB9HAAA4gcAAEcTAACsHgAAEQoAAHYVAADbAAAAQAwAAKUXAAAKAwAAbw4AANQZAAA5BQAA
| nhAAAAMcAABoBwAAzRIAADIeAACXCQAA/BQAAGEAAADGCwAAKxcAAJACAAD1DQAAWhkAAL8EAAAkEAAAiRsAAO4GAABTEgAA
| uB0AAB0JAACCFAAA5x8AAEwLAACxFgAAFgIAAHsNAADgGAAARQQAAKoPAAAPGwAAdAYAANkRAAA+HQAAowgAAAgUAABtHwAA
| 0goAADcWAACcAQAAAQ0AAGYYAADLAwAAMA8AAJUaAAD6BQAAXxEAAMQcAAApCAAAjhMAAPMeAABYCgAAvRUAACIBAACHDAAA
| 7BcAAFEDAAC2DgAAGxoAAIAFAADlEAAAShwAAK8HAAAUEwAAeR4AAN4JAABDFQAAqAAAAA0MAAByFwAA1wIAADwOAAChGQAA
| BgUAAGsQAADQGwAANQcAAJoSAAD/HQAAZAkAAMkUAAAuAAAAkwsAAPgWAABdAgAAwg0AACcZAACMBAAA8Q8AAFYbAAC7BgAA
| IBIAAIUdAADqCAAATxQAALQfAAAZCwAAfhYAAOMBAABIDQAArRgAABIEAAB3DwAA3BoAAEEGAACmEQAACx0AAHAIAADVEwAA
| Oh8AAJ8KAAAEFgAAaQEAAM4MAAAzGAAAmAMAAP0OAABiGgAAxwUAAHEdAADWCAAAOxQAAKAfAAAFCwAAahYAAM8BAAA0DQAA
| mRgAAP4DAABjDwAAyBoAAC0GAACSEQAA9xwAAFwIAADBEwAAJh8AAIsKAADwFQAAVQEAALoMAAAfGAAAhAMAAOkOAABOGgAA
| swUAABgRAAB9HAAA4gcAAEcTAACsHgAAEQoAAHYVAADbAAAAQAwAAKUXAAAKAwAAbw4AANQZAAA5BQAAnhAAAAMcAABoBwAA
| zRIAADIeAACXCQAA/BQAAGEAAADGCwAAKxcAAJACAAD1DQAAWhkAAL8EAAAkEAAAiRsAAO4GAABTEgAAuB0AAB0JAACCFAAA
| 5x8AAEwLAACxFgAAFgIAAHsNAADgGAAARQQAAKoPAAAPGwAAdAYAANkRAAA+HQAAowgAAAgUAABtHwAA0goAADcWAACcAQAA
| AQ0AAGYYAADLAwAAMA8AAJUaAAD6BQAAXxEAAMQcAAApCAAAjhMAAPMeAABYCgAAvRUAACIBAACHDAAA7BcAAFEDAAC2DgAA
| GxoAAIAFAADlEAAAShwAAK8HAAAUEwAAeR4AAN4JAABDFQAAqAAAAA0MAAByFwAA1wIAADwOAAChGQAABgUAAGsQAADQGwAA
| NQcAAJoSAAD/HQAAZAkAAMkUAAAuAAAAkwsAAPgWAABdAgAAwg0AACcZAACMBAAA8Q8AAFYbAAC7BgAAIBIAAIUdAADqCAAA
| TxQAALQfAAAZCwAAfhYAAOMBAABIDQAArRgAABIEAAB3DwAA3BoAAEEGAACmEQAACx0AAHAIAADVEwAAOh8AAJ8KAAAEFgAA
| aQEAAM4MAAAzGAAAmAMAAP0OAABiGgAAxwUAACwRAACRHAAA9gcAAFsTAADAHgAAJQoAAIoVAADvAAAAVAwAALkXAAAeAwAA
| gw4AAOgZAABNBQAAshAAABccAAB8BwAA4RIAAEYeAACrCQAAEBUAAHUAAADaCwAAPxcAAKQCAAAJDgAAbhkAANMEAAA4EAAA
| nRsAAAIHAABnEgAAzB0AADEJAACWFAAA+x8AAGALAADFFgAAKgIAAI8NAAD0GAAAWQQAAL4PAAAjGwAAiAYAAO0RAABSHQAA
| twgAABwUAACBHwAA5goAAEsWAACwAQAAFQ0AAHoYAADfAwAARA8AAKkaAAAOBgAAcxEAANgcAAA9CAAAohMAAAcfAABsCgAA
| 0RUAADYBAACbDAAAABgAAGUDAADKDgAALxoAAJQFAAD5EAAAXhwAAMMHAAAoEwAAjR4AAPIJAABXFQAAvAAAACEMAACGFwAA
| 6wIAAFAOAAC1GQAAGgUAAH8QAADkGwAASQcAAK4SAAATHgAAeAkAAN0UAABCAAAApwsAAAwXAAC2DgAAGxoAAIAFAADlEAAA
| ShwAAK8HAAAUEwAAeR4AAN4JAABDFQAAqAAAAA0MAAByFwAA1wIAADwOAAChGQAABgUAAGsQAADQGwAANQcAAJoSAAD/HQAA
| ZAkAAMkUAAAuAAAAkwsAAPgWAABdAgAAwg0AACcZAACMBAAA8Q8AAFYbAAC7BgAAIBIAAIUdAADqCAAATxQAALQfAAAZCwAA
| fhYAAOMBAABIDQAArRgAABIEAAB3DwAA3BoAAEEGAACmEQAACx0AAHAIAADVEwAAOh8AAJ8KAAAEFgAAaQEAAM4MAAAzGAAA
| mAMAAP0OAABiGgAAxwUAACwRAACRHAAA9gcAAFsTAADAHgAAJQoAAIoVAADvAAAAVAwAALkXAAAeAwAAgw4AAOgZAABNBQAA
| shAAABccAAB8BwAA4RIAAEYeAACrCQAAEBUAAHUAAADaCwAAPxcAAKQCAAAJDgAAbhkAANMEAAA4EAAAnRsAAAIHAABnEgAA
| zB0AADEJAACWFAAA+x8AAGALAADFFgAAKgIAAI8NAAD0GAAAWQQAAL4PAAAjGwAAiAYAAO0RAABSHQAAtwgAABwUAACBHwAA
| 5goAAEsWAACwAQAAFQ0AAHoYAADfAwAARA8AAKkaAAAOBgAAcxEAANgcAAA9CAAAohMAAAcfAABsCgAA0RUAADYBAACbDAAA
| ABgAAGUDAADKDgAALxoAAJQFAAD5EAAAXhwAAMMHAAAoEwAAjR4AAPIJAABXFQAAvAAAACEMAACGFwAA6wIAAFAOAAC1GQAA
| GgUAAH8QAADkGwAASQcAAK4SAAATHgAAeAkAAN0UAABCAAAApwsAAAwXAABxAgAA1g0AADsZAACgBAAABRAAAGobAADPBgAA
| NBIAAJkdAAD+CAAAYxQAAMgfAAAtCwAAkhYAAPcBAABcDQAAwRgAACYEAACLDwAA8BoAAFUGAAC6EQAAHx0AAIQIAADpEwAA
| Th8AALMKAAAYFgAAfQEAAOIMAABHGAAArAMAABEPAAB2GgAA2wUAAEARAAClHAAACggAAG8TAADUHgAAOQoAAJ4VAAADAQAA
| aAwAAM0XAAAyAwAAlw4AAPwZAABhBQAAxhAAACscAACQBwAA9RIAAFoeAAC/CQAAJBUAAIkAAADuCwAAUxcAALgCAAAdDgAA
| ghkAAOcEAABMEAAAsRsAABYHAAB7EgAA4B0AAEUJAACqFAAADwAAAHQLAADZFgAAPgIAAKMNAAAIGQAAbQQAANIPAAA3GwAA
| nAYAAAESAABmHQAAywgAADAUAACVHwAA+goAAF8WAADEAQAAKQ0AAI4YAADzAwAAWA8AAL0aAAAiBgAAhxEAAOwcAABRCAAA
| +x8AAGALAADFFgAAKgIAAI8NAAD0GAAAWQQAAL4PAAAjGwAAiAYAAO0RAABSHQAAtwgAABwUAACBHwAA5goAAEsWAACwAQAA
| FQ0AAHoYAADfAwAARA8AAKkaAAAOBgAAcxEAANgcAAA9CAAAohMAAAcfAABsCgAA0RUAADYBAACbDAAAABgAAGUDAADKDgAA
| LxoAAJQFAAD5EAAAXhwAAMMHAAAoEwAAjR4AAPIJAABXFQAAvAAAACEMAACGFwAA6wIAAFAOAAC1GQAAGgUAAH8QAADkGwAA
| SQcAAK4SAAATHgAAeAkAAN0UAABCAAAApwsAAAwXAABxAgAA1g0AADsZAACgBAAABRAAAGobAADPBgAANBIAAJkdAAD+CAAA
| YxQAAMgfAAAtCwAAkhYAAPcBAABcDQAAwRgAACYEAACLDwAA8BoAAFUGAAC6EQAAHx0AAIQIAADpEwAATh8AALMKAAAYFgAA
| fQEAAOIMAABHGAAArAMAABEPAAB2GgAA2wUAAEARAAClHAAACggAAG8TAADUHgAAOQoAAJ4VAAADAQAAaAwAAM0XAAAyAwAA
| lw4AAPwZAABhBQAAxhAAACscAACQBwAA9RIAAFoeAAC/CQAAJBUAAIkAAADuCwAAUxcAALgCAAAdDgAAghkAAOcEAABMEAAA
| sRsAABYHAAB7EgAA4B0AAEUJAACqFAAADwAAAHQLAADZFgAAPgIAAKMNAAAIGQAAbQQAANIPAAA3GwAAnAYAAAESAABmHQAA
| ywgAADAUAACVHwAA+goAAF8WAADEAQAAKQ0AAI4YAADzAwAAWA8AAL0aAAAiBgAAhxEAAOwcAABRCAAAthMAABsfAACACgAA
| 5RUAAEoBAACvDAAAFBgAAHkDAADeDgAAQxoAAKgFAAANEQAAchwAANcHAAA8EwAAoR4AAAYKAABrFQAA0AAAADUMAACaFwAA
| /wIAAGQOAADJGQAALgUAAJMQAAD4GwAAXQcAAMISAAAnHgAAjAkAAPEUAABWAAAAuwsAACAXAACFAgAA6g0AAE8ZAAC0BAAA
| GRAAAH4bAADjBgAASBIAAK0dAAASCQAAdxQAANwfAABBCwAAphYAAAsCAABwDQAA1RgAADoEAACfDwAABBsAAGkGAADOEQAA
| Mx0AAJgIAAD9EwAAYh8AAMcKAAAsFgAAkQEAAPYMAABbGAAAwAMAACUPAACKGgAA7wUAAFQRAAC5HAAAHggAAIMTAADoHgAA
| TQoAALIVAAAXAQAAfAwAAOEXAABGAwAAqw4AABAaAAB1BQAA2hAAAD8cAACkBwAACRMAAG4eAADTCQAAOBUAAJ0AAAACDAAA
| ZxcAAMwCAAAxDgAAlhkAAEARAAClHAAACggAAG8TAADUHgAAOQoAAJ4VAAADAQAAaAwAAM0XAAAyAwAAlw4AAPwZAABhBQAA
| xhAAACscAACQBwAA9RIAAFoeAAC/CQAAJBUAAIkAAADuCwAAUxcAALgCAAAdDgAAghkAAOcEAABMEAAAsRsAABYHAAB7EgAA
| 4B0AAEUJAACqFAAADwAAAHQLAADZFgAAPgIAAKMNAAAIGQAAbQQAANIPAAA3GwAAnAYAAAESAABmHQAAywgAADAUAACVHwAA
| +goAAF8WAADEAQAAKQ0AAI4YAADzAwAAWA8AAL0aAAAiBgAAhxEAAOwcAABRCAAAthMAABsfAACACgAA5RUAAEoBAACvDAAA
| FBgAAHkDAADeDgAAQxoAAKgFAAANEQAAchwAANcHAAA8EwAAoR4AAAYKAABrFQAA0AAAADUMAACaFwAA/wIAAGQOAADJGQAA
| LgUAAJMQAAD4GwAAXQcAAMISAAAnHgAAjAkAAPEUAABWAAAAuwsAACAXAACFAgAA6g0AAE8ZAAC0BAAAGRAAAH4bAADjBgAA
| SBIAAK0dAAASCQAAdxQAANwfAABBCwAAphYAAAsCAABwDQAA1RgAADoEAACfDwAABBsAAGkGAADOEQAAMx0AAJgIAAD9EwAA
| Yh8AAMcKAAAsFgAAkQEAAPYMAABbGAAAwAMAACUPAACKGgAA7wUAAFQRAAC5HAAAHggAAIMTAADoHgAATQoAALIVAAAXAQAA
| fAwAAOEXAABGAwAAqw4AABAaAAB1BQAA2hAAAD8cAACkBwAACRMAAG4eAADTCQAAOBUAAJ0AAAACDAAAZxcAAMwCAAAxDgAA
| lhkAAPsEAABgEAAAxRsAACoHAACPEgAA9B0AAFkJAAC+FAAAIwAAAIgLAADtFgAAUgIAALcNAAAcGQAAgQQAAOYPAABLGwAA
| sAYAABUSAAB6HQAA3wgAAEQUAACpHwAADgsAAHMWAADYAQAAPQ0AAKIYAAAHBAAAbA8AANEaAAA2BgAAmxEAAAAdAABlCAAA
| yhMAAC8fAACUCgAA+RUAAF4BAADDDAAAKBgAAI0DAADyDgAAVxoAALwFAAAhEQAAhhwAAOsHAABQEwAAtR4AABoKAAB/FQAA
| 5AAAAEkMAACuFwAAEwMAAHgOAADdGQAAQgUAAKcQAAAMHAAAcQcAANYSAAA7HgAAoAkAAAUVAABqAAAAzwsAADQXAACZAgAA
| /g0AAGMZAADIBAAALRAAAJIbAAD3BgAAXBIAAMEdAAAmCQAAixQAAPAfAABVCwAAuhYAAB8CAACEDQAA6RgAAE4EAACzDwAA
| GBsAAH0GAADiEQAARx0AAKwIAAARFAAAdh8AANsKAACFAgAA6g0AAE8ZAAC0BAAAGRAAAH4bAADjBgAASBIAAK0dAAASCQAA
| dxQAANwfAABBCwAAphYAAAsCAABwDQAA1RgAADoEAACfDwAABBsAAGkGAADOEQAAMx0AAJgIAAD9EwAAYh8AAMcKAAAsFgAA
| kQEAAPYMAABbGAAAwAMAACUPAACKGgAA7wUAAFQRAAC5HAAAHggAAIMTAADoHgAATQoAALIVAAAXAQAAfAwAAOEXAABGAwAA
| qw4AABAaAAB1BQAA2hAAAD8cAACkBwAACRMAAG4eAADTCQAAOBUAAJ0AAAACDAAAZxcAAMwCAAAxDgAAlhkAAPsEAABgEAAA
| xRsAACoHAACPEgAA9B0AAFkJAAC+FAAAIwAAAIgLAADtFgAAUgIAALcNAAAcGQAAgQQAAOYPAABLGwAAsAYAABUSAAB6HQAA
| 3wgAAEQUAACpHwAADgsAAHMWAADYAQAAPQ0AAKIYAAAHBAAAbA8AANEaAAA2BgAAmxEAAAAdAABlCAAAyhMAAC8fAACUCgAA
| +RUAAF4BAADDDAAAKBgAAI0DAADyDgAAVxoAALwFAAAhEQAAhhwAAOsHAABQEwAAtR4AABoKAAB/FQAA5AAAAEkMAACuFwAA
| EwMAAHgOAADdGQAAQgUAAKcQAAAMHAAAcQcAANYSAAA7HgAAoAkAAAUVAABqAAAAzwsAADQXAACZAgAA/g0AAGMZAADIBAAA
| LRAAAJIbAAD3BgAAXBIAAMEdAAAmCQAAixQAAPAfAABVCwAAuhYAAB8CAACEDQAA6RgAAE4EAACzDwAAGBsAAH0GAADiEQAA
| Rx0AAKwIAAARFAAAdh8AANsKAABAFgAApQEAAAoNAABvGAAA1AMAADkPAACeGgAAAwYAAGgRAADNHAAAMggAAJcTAAD8HgAA
| YQoAAMYVAAArAQAAkAwAAPUXAABaAwAAvw4AACQaAACJBQAA7hAAAFMcAAC4BwAAHRMAAIIeAADnCQAATBUAALEAAAAWDAAA
| excAAOACAABFDgAAqhkAAA8FAAB0EAAA2RsAAD4HAACjEgAACB4AAG0JAADSFAAANwAAAJwLAAABFwAAZgIAAMsNAAAwGQAA
| lQQAAPoPAABfGwAAxAYAACkSAACOHQAA8wgAAFgUAAC9HwAAIgsAAIcWAADsAQAAUQ0AALYYAAAbBAAAgA8AAOUaAABKBgAA
| rxEAABQdAAB5CAAA3hMAAEMfAACoCgAADRYAAHIBAADXDAAAPBgAAKEDAAAGDwAAaxoAANAFAAA1EQAAmhwAAP8HAABkEwAA
| yR4AAC4KAACTFQAA+AAAAF0MAADCFwAAJwMAAIwOAADxGQAAVgUAALsQAAAgHAAAyhMAAC8fAACUCgAA+RUAAF4BAADDDAAA
| KBgAAI0DAADyDgAAVxoAALwFAAAhEQAAhhwAAOsHAABQEwAAtR4AABoKAAB/FQAA5AAAAEkMAACuFwAAEwMAAHgOAADdGQAA
| QgUAAKcQAAAMHAAAcQcAANYSAAA7HgAAoAkAAAUVAABqAAAAzwsAADQXAACZAgAA/g0AAGMZAADIBAAALRAAAJIbAAD3BgAA
| XBIAAMEdAAAmCQAAixQAAPAfAABVCwAAuhYAAB8CAACEDQAA6RgAAE4EAACzDwAAGBsAAH0GAADiEQAARx0AAKwIAAARFAAA
| dh8AANsKAABAFgAApQEAAAoNAABvGAAA1AMAADkPAACeGgAAAwYAAGgRAADNHAAAMggAAJcTAAD8HgAAYQoAAMYVAAArAQAA
| kAwAAPUXAABaAwAAvw4AACQaAACJBQAA7hAAAFMcAAC4BwAAHRMAAIIeAADnCQAATBUAALEAAAAWDAAAexcAAOACAABFDgAA
| qhkAAA8FAAB0EAAA2RsAAD4HAACjEgAACB4AAG0JAADSFAAANwAAAJwLAAABFwAAZgIAAMsNAAAwGQAAlQQAAPoPAABfGwAA
| xAYAACkSAACOHQAA8wgAAFgUAAC9HwAAIgsAAIcWAADsAQAAUQ0AALYYAAAbBAAAgA8AAOUaAABKBgAArxEAABQdAAB5CAAA
| 3hMAAEMfAACoCgAADRYAAHIBAADXDAAAPBgAAKEDAAAGDwAAaxoAANAFAAA1EQAAmhwAAP8HAABkEwAAyR4AAC4KAACTFQAA
| +AAAAF0MAADCFwAAJwMAAIwOAADxGQAAVgUAALsQAAAgHAAAhQcAAOoSAABPHgAAtAkAABkVAAB+AAAA4wsAAEgXAACtAgAA
| Eg4AAHcZAADcBAAAQRAAAKYbAAALBwAAcBIAANUdAAA6CQAAnxQAAAQAAABpCwAAzhYAADMCAACYDQAA/RgAAGIEAADHDwAA
| LBsAAJEGAAD2EQAAWx0AAMAIAAAlFAAAih8AAO8KAABUFgAAuQEAAB4NAACDGAAA6AMAAE0PAACyGgAAFwYAAHwRAADhHAAA
| RggAAKsTAAAQHwAAdQoAANoVAAA/AQAApAwAAAkYAABuAwAA0w4AADgaAACdBQAAAhEAAGccAADMBwAAMRMAAJYeAAD7CQAA
| YBUAAMUAAAAqDAAAjxcAAPQCAABZDgAAvhkAACMFAACIEAAA7RsAAFIHAAC3EgAAHB4AAIEJAADmFAAASwAAALALAAAVFwAA
| egIAAN8NAABEGQAAqQQAAA4QAABzGwAA2AYAAD0SAACiHQAABwkAAGwUAADRHwAANgsAAJsWAAAAAgAAZQ0AAA8FAAB0EAAA
| 2RsAAD4HAACjEgAACB4AAG0JAADSFAAANwAAAJwLAAABFwAAZgIAAMsNAAAwGQAAlQQAAPoPAABfGwAAxAYAACkSAACOHQAA
| 8wgAAFgUAAC9HwAAIgsAAIcWAADsAQAAUQ0AALYYAAAbBAAAgA8AAOUaAABKBgAArxEAABQdAAB5CAAA3hMAAEMfAACoCgAA
| DRYAAHIBAADXDAAAPBgAAKEDAAAGDwAAaxoAANAFAAA1EQAAmhwAAP8HAABkEwAAyR4AAC4KAACTFQAA+AAAAF0MAADCFwAA
| JwMAAIwOAADxGQAAVgUAALsQAAAgHAAAhQcAAOoSAABPHgAAtAkAABkVAAB+AAAA4wsAAEgXAACtAgAAEg4AAHcZAADcBAAA
| QRAAAKYbAAALBwAAcBIAANUdAAA6CQAAnxQAAAQAAABpCwAAzhYAADMCAACYDQAA/RgAAGIEAADHDwAALBsAAJEGAAD2EQAA
| Wx0AAMAIAAAlFAAAih8AAO8KAABUFgAAuQEAAB4NAACDGAAA6AMAAE0PAACyGgAAFwYAAHwRAADhHAAARggAAKsTAAAQHwAA
| dQoAANoVAAA/AQAApAwAAAkYAABuAwAA0w4AADgaAACdBQAAAhEAAGccAADMBwAAMRMAAJYeAAD7CQAAYBUAAMUAAAAqDAAA
| jxcAAPQCAABZDgAAvhkAACMFAACIEAAA7RsAAFIHAAC3EgAAHB4AAIEJAADmFAAASwAAALALAAAVFwAAegIAAN8NAABEGQAA
| qQQAAA4QAABzGwAA2AYAAD0SAACiHQAABwkAAGwUAADRHwAANgsAAJsWAAAAAgAAZQ0AAMoYAAAvBAAAlA8AAPkaAABeBgAA
| wxEAACgdAACNCAAA8hMAAFcfAAC8CgAAIRYAAIYBAADrDAAAUBgAALUDAAAaDwAAfxoAAOQFAABJEQAArhwAABMIAAB4EwAA
| 3R4AAEIKAACnFQAADAEAAHEMAADWFwAAOwMAAKAOAAAFGgAAagUAAM8QAAA0HAAAmQcAAP4SAABjHgAAyAkAAC0VAACSAAAA
| 9wsAAFwXAADBAgAAJg4AAIsZAADwBAAAVRAAALobAAAfBwAAhBIAAOkdAABOCQAAsxQAABgAAAB9CwAA4hYAAEcCAACsDQAA
| ERkAAHYEAADbDwAAQBsAAKUGAAAKEgAAbx0AANQIAAA5FAAAnh8AAAMLAABoFgAAzQEAADINAACXGAAA/AMAAGEPAADGGgAA
| KwYAAJARAAD1HAAAWggAAL8TAAAkHwAAiQoAAO4VAABTAQAAuAwAAB0YAACCAwAA5w4AAEwaAACxBQAAFhEAAHscAADgBwAA
| RRMAAKoeAABUFgAAuQEAAB4NAACDGAAA6AMAAE0PAACyGgAAFwYAAHwRAADhHAAARggAAKsTAAAQHwAAdQoAANoVAAA/AQAA
| pAwAAAkYAABuAwAA0w4AADgaAACdBQAAAhEAAGccAADMBwAAMRMAAJYeAAD7CQAAYBUAAMUAAAAqDAAAjxcAAPQCAABZDgAA
| vhkAACMFAACIEAAA7RsAAFIHAAC3EgAAHB4AAIEJAADmFAAASwAAALALAAAVFwAAegIAAN8NAABEGQAAqQQAAA4QAABzGwAA
| 2AYAAD0SAACiHQAABwkAAGwUAADRHwAANgsAAJsWAAAAAgAAZQ0AAMoYAAAvBAAAlA8AAPkaAABeBgAAwxEAACgdAACNCAAA
| 8hMAAFcfAAC8CgAAIRYAAIYBAADrDAAAUBgAALUDAAAaDwAAfxoAAOQFAABJEQAArhwAABMIAAB4EwAA3R4AAEIKAACnFQAA
| DAEAAHEMAADWFwAAOwMAAKAOAAAFGgAAagUAAM8QAAA0HAAAmQcAAP4SAABjHgAAyAkAAC0VAACSAAAA9wsAAFwXAADBAgAA
| Jg4AAIsZAADwBAAAVRAAALobAAAfBwAAhBIAAOkdAABOCQAAsxQAABgAAAB9CwAA4hYAAEcCAACsDQAAERkAAHYEAADbDwAA
| QBsAAKUGAAAKEgAAbx0AANQIAAA5FAAAnh8AAAMLAABoFgAAzQEAADINAACXGAAA/AMAAGEPAADGGgAAKwYAAJARAAD1HAAA
| WggAAL8TAAAkHwAAiQoAAO4VAABTAQAAuAwAAB0YAACCAwAA5w4AAEwaAACxBQAAFhEAAHscAADgBwAARRMAAKoeAAAPCgAA
| dBUAANkAAAA+DAAAoxcAAAgDAABtDgAA0hkAADcFAACcEAAAARwAAGYHAADLEgAAMB4AAJUJAAD6FAAAXwAAAMQLAAApFwAA
| jgIAAPMNAABYGQAAvQQAACIQAACHGwAA7AYAAFESAAC2HQAAGwkAAIAUAADlHwAASgsAAK8WAAAUAgAAeQ0AAN4YAABDBAAA
| qA8AAA0bAAByBgAA1xEAADwdAAChCAAABhQAAGsfAADQCgAANRYAAJoBAAD/DAAAZBgAAMkDAAAuDwAAkxoAAPgFAABdEQAA
| whwAACcIAACMEwAA8R4AAFYKAAC7FQAAIAEAAIUMAADqFwAATwMAALQOAAAZGgAAfgUAAOMQAABIHAAArQcAABITAAB3HgAA
| 3AkAAEEVAACmAAAACwwAAHAXAADVAgAAOg4AAJ8ZAAAEBQAAaRAAAM4bAAAzBwAAmBIAAP0dAABiCQAAxxQAACwAAACRCwAA
| 9hYAAFsCAADADQAAJRkAAIoEAADvDwAAmQcAAP4SAABjHgAAyAkAAC0VAACSAAAA9wsAAFwXAADBAgAAJg4AAIsZAADwBAAA
| VRAAALobAAAfBwAAhBIAAOkdAABOCQAAsxQAABgAAAB9CwAA4hYAAEcCAACsDQAAERkAAHYEAADbDwAAQBsAAKUGAAAKEgAA
| bx0AANQIAAA5FAAAnh8AAAMLAABoFgAAzQEAADINAACXGAAA/AMAAGEPAADGGgAAKwYAAJARAAD1HAAAWggAAL8TAAAkHwAA
| iQoAAO4VAABTAQAAuAwAAB0YAACCAwAA5w4AAEwaAACxBQAAFhEAAHscAADgBwAARRMAAKoeAAAPCgAAdBUAANkAAAA+DAAA
| oxcAAAgDAABtDgAA0hkAADcFAACcEAAAARwAAGYHAADLEgAAMB4AAJUJAAD6FAAAXwAAAMQLAAApFwAAjgIAAPMNAABYGQAA
| vQQAACIQAACHGwAA7AYAAFESAAC2HQAAGwkAAIAUAADlHwAASgsAAK8WAAAUAgAAeQ0AAN4YAABDBAAAqA8AAA0bAAByBgAA
| 1xEAADwdAAChCAAABhQAAGsfAADQCgAANRYAAJoBAAD/DAAAZBgAAMkDAAAuDwAAkxoAAPgFAABdEQAAwhwAACcIAACMEwAA
| 8R4AAFYKAAC7FQAAIAEAAIUMAADqFwAATwMAALQOAAAZGgAAfgUAAOMQAABIHAAArQcAABITAAB3HgAA3AkAAEEVAACmAAAA
| CwwAAHAXAADVAgAAOg4AAJ8ZAAAEBQAAaRAAAM4bAAAzBwAAmBIAAP0dAABiCQAAxxQAACwAAACRCwAA9hYAAFsCAADADQAA
| JRkAAIoEAADvDwAAVBsAALkGAAAeEgAAgx0AAOgIAABNFAAAsh8AABcLAAB8FgAA4QEAAEYNAACrGAAAEAQAAHUPAADaGgAA
| PwYAAKQRAAAJHQAAbggAANMTAAA4HwAAnQoAAAIWAABnAQAAzAwAADEYAACWAwAA+w4AAGAaAADFBQAAKhEAAI8cAAD0BwAA
| WRMAAL4eAAAjCgAAiBUAAO0AAABSDAAAtxcAABwDAACBDgAA5hkAAEsFAACwEAAAFRwAAHoHAADfEgAARB4AAKkJAAAOFQAA
| cwAAANgLAAA9FwAAogIAAAcOAABsGQAA0QQAADYQAACbGwAAAAcAAGUSAADKHQAALwkAAJQUAAD5HwAAXgsAAMMWAAAoAgAA
| jQ0AAPIYAABXBAAAvA8AACEbAACGBgAA6xEAAFAdAAC1CAAAGhQAAH8fAADkCgAASRYAAK4BAAATDQAAeBgAAN0DAABCDwAA
| pxoAAAwGAABxEQAA1hwAADsIAACgEwAABR8AAGoKAADPFQAANAEAAN4YAABDBAAAqA8AAA0bAAByBgAA1xEAADwdAAChCAAA
| BhQAAGsfAADQCgAANRYAAJoBAAD/DAAAZBgAAMkDAAAuDwAAkxoAAPgFAABdEQAAwhwAACcIAACMEwAA8R4AAFYKAAC7FQAA
| IAEAAIUMAADqFwAATwMAALQOAAAZGgAAfgUAAOMQAABIHAAArQcAABITAAB3HgAA3AkAAEEVAACmAAAACwwAAHAXAADVAgAA
| Og4AAJ8ZAAAEBQAAaRAAAM4bAAAzBwAAmBIAAP0dAABiCQAAxxQAACwAAACRCwAA9hYAAFsCAADADQAAJRkAAIoEAADvDwAA
| VBsAALkGAAAeEgAAgx0AAOgIAABNFAAAsh8AABcLAAB8FgAA4QEAAEYNAACrGAAAEAQAAHUPAADaGgAAPwYAAKQRAAAJHQAA
| bggAANMTAAA4HwAAnQoAAAIWAABnAQAAzAwAADEYAACWAwAA+w4AAGAaAADFBQAAKhEAAI8cAAD0BwAAWRMAAL4eAAAjCgAA
| iBUAAO0AAABSDAAAtxcAABwDAACBDgAA5hkAAEsFAACwEAAAFRwAAHoHAADfEgAARB4AAKkJAAAOFQAAcwAAANgLAAA9FwAA
| ogIAAAcOAABsGQAA0QQAADYQAACbGwAAAAcAAGUSAADKHQAALwkAAJQUAAD5HwAAXgsAAMMWAAAoAgAAjQ0AAPIYAABXBAAA
| vA8AACEbAACGBgAA6xEAAFAdAAC1CAAAGhQAAH8fAADkCgAASRYAAK4BAAATDQAAeBgAAN0DAABCDwAApxoAAAwGAABxEQAA
| 1hwAADsIAACgEwAABR8AAGoKAADPFQAANAEAAJkMAAD+FwAAYwMAAMgOAAAtGgAAkgUAAPcQAABcHAAAwQcAACYTAACLHgAA
| 8AkAAFUVAAC6AAAAHwwAAIQXAADpAgAATg4AALMZAAAYBQAAfRAAAOIbAABHBwAArBIAABEeAAB2CQAA2xQAAEAAAAClCwAA
| ChcAAG8CAADUDQAAORkAAJ4EAAADEAAAaBsAAM0GAAAyEgAAlx0AAPwIAABhFAAAxh8AACsLAACQFgAA9QEAAFoNAAC/GAAA
| JAQAAIkPAADuGgAAUwYAALgRAAAdHQAAgggAAOcTAABMHwAAsQoAABYWAAB7AQAA4AwAAEUYAACqAwAADw8AAHQaAADZBQAA
| PhEAAKMcAAAICAAAbRMAANIeAAA3CgAAnBUAAAEBAABmDAAAyxcAADADAACVDgAA+hkAAF8FAADEEAAAKRwAAI4HAADzEgAA
| WB4AAL0JAAAiFQAAhwAAAOwLAABRFwAAtgIAABsOAACAGQAA5QQAAEoQAACvGwAAFAcAAHkSAAAjCgAAiBUAAO0AAABSDAAA
| txcAABwDAACBDgAA5hkAAEsFAACwEAAAFRwAAHoHAADfEgAARB4AAKkJAAAOFQAAcwAAANgLAAA9FwAAogIAAAcOAABsGQAA
| 0QQAADYQAACbGwAAAAcAAGUSAADKHQAALwkAAJQUAAD5HwAAXgsAAMMWAAAoAgAAjQ0AAPIYAABXBAAAvA8AACEbAACGBgAA
| 6xEAAFAdAAC1CAAAGhQAAH8fAADkCgAASRYAAK4BAAATDQAAeBgAAN0DAABCDwAApxoAAAwGAABxEQAA1hwAADsIAACgEwAA
| BR8AAGoKAADPFQAANAEAAJkMAAD+FwAAYwMAAMgOAAAtGgAAkgUAAPcQAABcHAAAwQcAACYTAACLHgAA8AkAAFUVAAC6AAAA
| HwwAAIQXAADpAgAATg4AALMZAAAYBQAAfRAAAOIbAABHBwAArBIAABEeAAB2CQAA2xQAAEAAAAClCwAAChcAAG8CAADUDQAA
| ORkAAJ4EAAADEAAAaBsAAM0GAAAyEgAAlx0AAPwIAABhFAAAxh8AACsLAACQFgAA9QEAAFoNAAC/GAAAJAQAAIkPAADuGgAA
| UwYAALgRAAAdHQAAgggAAOcTAABMHwAAsQoAABYWAAB7AQAA4AwAAEUYAACqAwAADw8AAHQaAADZBQAAPhEAAKMcAAAICAAA
| bRMAANIeAAA3CgAAnBUAAAEBAABmDAAAyxcAADADAACVDgAA+hkAAF8FAADEEAAAKRwAAI4HAADzEgAAWB4AAL0JAAAiFQAA
| hwAAAOwLAABRFwAAtgIAABsOAACAGQAA5QQAAEoQAACvGwAAFAcAAHkSAADeHQAAQwkAAKgUAAANAAAAcgsAANcWAAA8AgAA
| oQ0AAAYZAABrBAAA0A8AADUbAACaBgAA/xEAAGQdAADJCAAALhQAAJMfAAD4CgAAXRYAAMIBAAAnDQAAjBgAAPEDAABWDwAA
| uxoAACAGAACFEQAA6hwAAE8IAAC0EwAAGR8AAH4KAADjFQAASAEAAK0MAAASGAAAdwMAANwOAABBGgAApgUAAAsRAABwHAAA
| 1QcAADoTAACfHgAABAoAAGkVAADOAAAAMwwAAJgXAAD9AgAAYg4AAMcZAAAsBQAAkRAAAPYbAABbBwAAwBIAACUeAACKCQAA
| 7xQAAFQAAAC5CwAAHhcAAIMCAADoDQAATRkAALIEAAAXEAAAfBsAAOEGAABGEgAAqx0AABAJAAB1FAAA2h8AAD8LAACkFgAA
| CQIAAG4NAADTGAAAOAQAAJ0PAAACGwAAZwYAAMwRAAAxHQAAlggAAPsTAABgHwAAxQoAACoWAACPAQAA9AwAAFkYAAC+AwAA
| aBsAAM0GAAAyEgAAlx0AAPwIAABhFAAAxh8AACsLAACQFgAA9QEAAFoNAAC/GAAAJAQAAIkPAADuGgAAUwYAALgRAAAdHQAA
| gggAAOcTAABMHwAAsQoAABYWAAB7AQAA4AwAAEUYAACqAwAADw8AAHQaAADZBQAAPhEAAKMcAAAICAAAbRMAANIeAAA3CgAA
| nBUAAAEBAABmDAAAyxcAADADAACVDgAA+hkAAF8FAADEEAAAKRwAAI4HAADzEgAAWB4AAL0JAAAiFQAAhwAAAOwLAABRFwAA
| tgIAABsOAACAGQAA5QQAAEoQAACvGwAAFAcAAHkSAADeHQAAQwkAAKgUAAANAAAAcgsAANcWAAA8AgAAoQ0AAAYZAABrBAAA
| 0A8AADUbAACaBgAA/xEAAGQdAADJCAAALhQAAJMfAAD4CgAAXRYAAMIBAAAnDQAAjBgAAPEDAABWDwAAuxoAACAGAACFEQAA
| 6hwAAE8IAAC0EwAAGR8AAH4KAADjFQAASAEAAK0MAAASGAAAdwMAANwOAABBGgAApgUAAAsRAABwHAAA1QcAADoTAACfHgAA
| BAoAAGkVAADOAAAAMwwAAJgXAAD9AgAAYg4AAMcZAAAsBQAAkRAAAPYbAABbBwAAwBIAACUeAACKCQAA7xQAAFQAAAC5CwAA
| HhcAAIMCAADoDQAATRkAALIEAAAXEAAAfBsAAOEGAABGEgAAqx0AABAJAAB1FAAA2h8AAD8LAACkFgAACQIAAG4NAADTGAAA
| OAQAAJ0PAAACGwAAZwYAAMwRAAAxHQAAlggAAPsTAABgHwAAxQoAACoWAACPAQAA9AwAAFkYAAC+AwAAIw8AAIgaAADtBQAA
| UhEAALccAAAcCAAAgRMAAOYeAABLCgAAsBUAABUBAAB6DAAA3xcAAEQDAACpDgAADhoAAHMFAADYEAAAPRwAAKIHAAAHEwAA
| bB4AANEJAAA2FQAAmwAAAAAMAABlFwAAygIAAC8OAACUGQAA+QQAAF4QAADDGwAAKAcAAI0SAADyHQAAVwkAALwUAAAhAAAA
| hgsAAOsWAABQAgAAtQ0AABoZAAB/BAAA5A8AAEkbAACuBgAAExIAAHgdAADdCAAAQhQAAKcfAAAMCwAAcRYAANYBAAA7DQAA
| oBgAAAUEAABqDwAAzxoAADQGAACZEQAA/hwAAGMIAADIEwAALR8AAJIKAAD3FQAAXAEAAMEMAAAmGAAAiwMAAPAOAABVGgAA
| ugUAAB8RAACEHAAA6QcAAE4TAACzHgAAGAoAAH0VAADiAAAARwwAAKwXAAARAwAAdg4AANsZAABABQAApRAAAAocAABvBwAA
| 1BIAADkeAACeCQAAAxUAAK0MAAASGAAAdwMAANwOAABBGgAApgUAAAsRAABwHAAA1QcAADoTAACfHgAABAoAAGkVAADOAAAA
| MwwAAJgXAAD9AgAAYg4AAMcZAAAsBQAAkRAAAPYbAABbBwAAwBIAACUeAACKCQAA7xQAAFQAAAC5CwAAHhcAAIMCAADoDQAA
| TRkAALIEAAAXEAAAfBsAAOEGAABGEgAAqx0AABAJAAB1FAAA2h8AAD8LAACkFgAACQIAAG4NAADTGAAAOAQAAJ0PAAACGwAA
| ZwYAAMwRAAAxHQAAlggAAPsTAABgHwAAxQoAACoWAACPAQAA9AwAAFkYAAC+AwAAIw8AAIgaAADtBQAAUhEAALccAAAcCAAA
| gRMAAOYeAABLCgAAsBUAABUBAAB6DAAA3xcAAEQDAACpDgAADhoAAHMFAADYEAAAPRwAAKIHAAAHEwAAbB4AANEJAAA2FQAA
| mwAAAAAMAABlFwAAygIAAC8OAACUGQAA+QQAAF4QAADDGwAAKAcAAI0SAADyHQAAVwkAALwUAAAhAAAAhgsAAOsWAABQAgAA
| tQ0AABoZAAB/BAAA5A8AAEkbAACuBgAAExIAAHgdAADdCAAAQhQAAKcfAAAMCwAAcRYAANYBAAA7DQAAoBgAAAUEAABqDwAA
| zxoAADQGAACZEQAA/hwAAGMIAADIEwAALR8AAJIKAAD3FQAAXAEAAMEMAAAmGAAAiwMAAPAOAABVGgAAugUAAB8RAACEHAAA
| 6QcAAE4TAACzHgAAGAoAAH0VAADiAAAARwwAAKwXAAARAwAAdg4AANsZAABABQAApRAAAAocAABvBwAA1BIAADkeAACeCQAA
| AxUAAGgAAADNCwAAMhcAAJcCAAD8DQAAYRkAAMYEAAArEAAAkBsAAPUGAABaEgAAvx0AACQJAACJFAAA7h8AAFMLAAC4FgAA
| HQIAAIINAADnGAAATAQAALEPAAAWGwAAewYAAOARAABFHQAAqggAAA8UAAB0HwAA2QoAAD4WAACjAQAACA0AAG0YAADSAwAA
| Nw8AAJwaAAABBgAAZhEAAMscAAAwCAAAlRMAAPoeAABfCgAAxBUAACkBAACODAAA8xcAAFgDAAC9DgAAIhoAAIcFAADsEAAA
| URwAALYHAAAbEwAAgB4AAOUJAABKFQAArwAAABQMAAB5FwAA3gIAAEMOAACoGQAADQUAAHIQAADXGwAAPAcAAKESAAAGHgAA
| awkAANAUAAA1AAAAmgsAAP8WAABkAgAAyQ0AAC4ZAACTBAAA+A8AAF0bAADCBgAAJxIAAIwdAADxCAAAVhQAALsfAAAgCwAA
| hRYAAOoBAABPDQAAtBgAABkEAAB+DwAA4xoAAEgGAADyHQAAVwkAALwUAAAhAAAAhgsAAOsWAABQAgAAtQ0AABoZAAB/BAAA
| 5A8AAEkbAACuBgAAExIAAHgdAADdCAAAQhQAAKcfAAAMCwAAcRYAANYBAAA7DQAAoBgAAAUEAABqDwAAzxoAADQGAACZEQAA
| /hwAAGMIAADIEwAALR8AAJIKAAD3FQAAXAEAAMEMAAAmGAAAiwMAAPAOAABVGgAAugUAAB8RAACEHAAA6QcAAE4TAACzHgAA
| GAoAAH0VAADiAAAARwwAAKwXAAARAwAAdg4AANsZAABABQAApRAAAAocAABvBwAA1BIAADkeAACeCQAAAxUAAGgAAADNCwAA
| MhcAAJcCAAD8DQAAYRkAAMYEAAArEAAAkBsAAPUGAABaEgAAvx0AACQJAACJFAAA7h8AAFMLAAC4FgAAHQIAAIINAADnGAAA
| TAQAALEPAAAWGwAAewYAAOARAABFHQAAqggAAA8UAAB0HwAA2QoAAD4WAACjAQAACA0AAG0YAADSAwAANw8AAJwaAAABBgAA
| ZhEAAMscAAAwCAAAlRMAAPoeAABfCgAAxBUAACkBAACODAAA8xcAAFgDAAC9DgAAIhoAAIcFAADsEAAAURwAALYHAAAbEwAA
| gB4AAOUJAABKFQAArwAAABQMAAB5FwAA3gIAAEMOAACoGQAADQUAAHIQAADXGwAAPAcAAKESAAAGHgAAawkAANAUAAA1AAAA
| mgsAAP8WAABkAgAAyQ0AAC4ZAACTBAAA+A8AAF0bAADCBgAAJxIAAIwdAADxCAAAVhQAALsfAAAgCwAAhRYAAOoBAABPDQAA
| tBgAABkEAAB+DwAA4xoAAEgGAACtEQAAEh0AAHcIAADcEwAAQR8AAKYKAAALFgAAcAEAANUMAAA6GAAAnwMAAAQPAABpGgAA
| zgUAADMRAACYHAAA/QcAAGITAADHHgAALAoAAJEVAAD2AAAAWwwAAMAXAAAlAwAAig4AAO8ZAABUBQAAuRAAAB4cAACDBwAA
| 6BIAAE0eAACyCQAAFxUAAHwAAADhCwAARhcAAKsCAAAQDgAAdRkAANoEAAA/EAAApBsAAAkHAABuEgAA0x0AADgJAACdFAAA
| AgAAAGcLAADMFgAAMQIAAJYNAAD7GAAAYAQAAMUPAAAqGwAAjwYAAPQRAABZHQAAvggAACMUAACIHwAA7QoAAFIWAAC3AQAA
| HA0AAIEYAADmAwAASw8AALAaAAAVBgAAehEAAN8cAABECAAAqRMAAA4fAABzCgAA2BUAAD0BAACiDAAABxgAAGwDAADRDgAA
| NhoAAJsFAAAAEQAAZRwAAMoHAAAvEwAAlB4AAPkJAABeFQAAwwAAACgMAACNFwAANw8AAJwaAAABBgAAZhEAAMscAAAwCAAA
| lRMAAPoeAABfCgAAxBUAACkBAACODAAA8xcAAFgDAAC9DgAAIhoAAIcFAADsEAAAURwAALYHAAAbEwAAgB4AAOUJAABKFQAA
| rwAAABQMAAB5FwAA3gIAAEMOAACoGQAADQUAAHIQAADXGwAAPAcAAKESAAAGHgAAawkAANAUAAA1AAAAmgsAAP8WAABkAgAA
| yQ0AAC4ZAACTBAAA+A8AAF0bAADCBgAAJxIAAIwdAADxCAAAVhQAALsfAAAgCwAAhRYAAOoBAABPDQAAtBgAABkEAAB+DwAA
| 4xoAAEgGAACtEQAAEh0AAHcIAADcEwAAQR8AAKYKAAALFgAAcAEAANUMAAA6GAAAnwMAAAQPAABpGgAAzgUAADMRAACYHAAA
| /QcAAGITAADHHgAALAoAAJEVAAD2AAAAWwwAAMAXAAAlAwAAig4AAO8ZAABUBQAAuRAAAB4cAACDBwAA6BIAAE0eAACyCQAA
| FxUAAHwAAADhCwAARhcAAKsCAAAQDgAAdRkAANoEAAA/EAAApBsAAAkHAABuEgAA0x0AADgJAACdFAAAAgAAAGcLAADMFgAA
| MQIAAJYNAAD7GAAAYAQAAMUPAAAqGwAAjwYAAPQRAABZHQAAvggAACMUAACIHwAA7QoAAFIWAAC3AQAAHA0AAIEYAADmAwAA
| Sw8AALAaAAAVBgAAehEAAN8cAABECAAAqRMAAA4fAABzCgAA2BUAAD0BAACiDAAABxgAAGwDAADRDgAANhoAAJsFAAAAEQAA
| ZRwAAMoHAAAvEwAAlB4AAPkJAABeFQAAwwAAACgMAACNFwAA8gIAAFcOAAC8GQAAIQUAAIYQAADrGwAAUAcAALUSAAAaHgAA
| fwkAAOQUAABJAAAArgsAABMXAAB4AgAA3Q0AAEIZAACnBAAADBAAAHEbAADWBgAAOxIAAKAdAAAFCQAAahQAAM8fAAA0CwAA
| mRYAAP4BAABjDQAAyBgAAC0EAACSDwAA9xoAAFwGAADBEQAAJh0AAIsIAADwEwAAVR8AALoKAAAfFgAAhAEAAOkMAABOGAAA
| swMAABgPAAB9GgAA4gUAAEcRAACsHAAAEQgAAHYTAADbHgAAQAoAAKUVAAAKAQAAbwwAANQXAAA5AwAAng4AAAMaAABoBQAA
| zRAAADIcAACXBwAA/BIAAGEeAADGCQAAKxUAAJAAAAD1CwAAWhcAAL8CAAAkDgAAiRkAAO4EAABTEAAAuBsAAB0HAACCEgAA
| 5x0AAEwJAACxFAAAFgAAAHsLAADgFgAARQIAAKoNAAAPGQAAdAQAANkPAAA+GwAAowYAAAgSAABtHQAA0ggAAHwAAADhCwAA
| RhcAAKsCAAAQDgAAdRkAANoEAAA/EAAApBsAAAkHAABuEgAA0x0AADgJAACdFAAAAgAAAGcLAADMFgAAMQIAAJYNAAD7GAAA
| YAQAAMUPAAAqGwAAjwYAAPQRAABZHQAAvggAACMUAACIHwAA7QoAAFIWAAC3AQAAHA0AAIEYAADmAwAASw8AALAaAAAVBgAA
| ehEAAN8cAABECAAAqRMAAA4fAABzCgAA2BUAAD0BAACiDAAABxgAAGwDAADRDgAANhoAAJsFAAAAEQAAZRwAAMoHAAAvEwAA
| lB4AAPkJAABeFQAAwwAAACgMAACNFwAA8gIAAFcOAAC8GQAAIQUAAIYQAADrGwAAUAcAALUSAAAaHgAAfwkAAOQUAABJAAAA
| rgsAABMXAAB4AgAA3Q0AAEIZAACnBAAADBAAAHEbAADWBgAAOxIAAKAdAAAFCQAAahQAAM8fAAA0CwAAmRYAAP4BAABjDQAA
| yBgAAC0EAACSDwAA9xoAAFwGAADBEQAAJh0AAIsIAADwEwAAVR8AALoKAAAfFgAAhAEAAOkMAABOGAAAswMAABgPAAB9GgAA
| 4gUAAEcRAACsHAAAEQgAAHYTAADbHgAAQAoAAKUVAAAKAQAAbwwAANQXAAA5AwAAng4AAAMaAABoBQAAzRAAADIcAACXBwAA
| /BIAAGEeAADGCQAAKxUAAJAAAAD1CwAAWhcAAL8CAAAkDgAAiRkAAO4EAABTEAAAuBsAAB0HAACCEgAA5x0AAEwJAACxFAAA
| FgAAAHsLAADgFgAARQIAAKoNAAAPGQAAdAQAANkPAAA+GwAAowYAAAgSAABtHQAA0ggAADcUAACcHwAAAQsAAGYWAADLAQAA
| MA0AAJUYAAD6AwAAXw8AAMQaAAApBgAAjhEAAPMcAABYCAAAvRMAACIfAACHCgAA7BUAAFEBAAC2DAAAGxgAAIADAADlDgAA
| ShoAAK8FAAAUEQAAeRwAAN4HAABDEwAAqB4AAA0KAAByFQAA1wAAADwMAAChFwAABgMAAGsOAADQGQAANQUAAJoQAAD/GwAA
| ZAcAAMkSAAAuHgAAkwkAAPgUAABdAAAAwgsAACcXAACMAgAA8Q0AAFYZAAC7BAAAIBAAAIUbAADqBgAATxIAALQdAAAZCQAA
| fhQAAOMfAABICwAArRYAABICAAB3DQAA3BgAAEEEAACmDwAACxsAAHAGAADVEQAAOh0AAJ8IAAAEFAAAaR8AAM4KAAAzFgAA
| mAEAAP0MAABiGAAAxwMAACwPAACRGgAA9gUAAFsRAADAHAAAJQgAAIoTAADvHgAAVAoAALkVAAAeAQAAgwwAAOgXAABNAwAA
| sg4AABcaAADBEQAAJh0AAIsIAADwEwAAVR8AALoKAAAfFgAAhAEAAOkMAABOGAAAswMAABgPAAB9GgAA4gUAAEcRAACsHAAA
| EQgAAHYTAADbHgAAQAoAAKUVAAAKAQAAbwwAANQXAAA5AwAAng4AAAMaAABoBQAAzRAAADIcAACXBwAA/BIAAGEeAADGCQAA
| KxUAAJAAAAD1CwAAWhcAAL8CAAAkDgAAiRkAAO4EAABTEAAAuBsAAB0HAACCEgAA5x0AAEwJAACxFAAAFgAAAHsLAADgFgAA
| RQIAAKoNAAAPGQAAdAQAANkPAAA+GwAAowYAAAgSAABtHQAA0ggAADcUAACcHwAAAQsAAGYWAADLAQAAMA0AAJUYAAD6AwAA
| Xw8AAMQaAAApBgAAjhEAAPMcAABYCAAAvRMAACIfAACHCgAA7BUAAFEBAAC2DAAAGxgAAIADAADlDgAAShoAAK8FAAAUEQAA
| eRwAAN4HAABDEwAAqB4AAA0KAAByFQAA1wAAADwMAAChFwAABgMAAGsOAADQGQAANQUAAJoQAAD/GwAAZAcAAMkSAAAuHgAA
| kwkAAPgUAABdAAAAwgsAACcXAACMAgAA8Q0AAFYZAAC7BAAAIBAAAIUbAADqBgAATxIAALQdAAAZCQAAfhQAAOMfAABICwAA
| rRYAABICAAB3DQAA3BgAAEEEAACmDwAACxsAAHAGAADVEQAAOh0AAJ8IAAAEFAAAaR8AAM4KAAAzFgAAmAEAAP0MAABiGAAA
| xwMAACwPAACRGgAA9gUAAFsRAADAHAAAJQgAAIoTAADvHgAAVAoAALkVAAAeAQAAgwwAAOgXAABNAwAAsg4AABcaAAB8BQAA
| 4RAAAEYcAACrBwAAEBMAAHUeAADaCQAAPxUAAKQAAAAJDAAAbhcAANMCAAA4DgAAnRkAAAIFAABnEAAAzBsAADEHAACWEgAA
| +x0AAGAJAADFFAAAKgAAAI8LAAD0FgAAWQIAAL4NAAAjGQAAiAQAAO0PAABSGwAAtwYAABwSAACBHQAA5ggAAEsUAACwHwAA
| FQsAAHoWAADfAQAARA0AAKkYAAAOBAAAcw8AANgaAAA9BgAAohEAAAcdAABsCAAA0RMAADYfAACbCgAAABYAAGUBAADKDAAA
| LxgAAJQDAAD5DgAAXhoAAMMFAAAoEQAAjRwAAPIHAABXEwAAvB4AACEKAACGFQAA6wAAAFAMAAC1FwAAGgMAAH8OAADkGQAA
| SQUAAK4QAAATHAAAeAcAAN0SAABCHgAApwkAAAwVAABxAAAA1gsAADsXAACgAgAABQ4AAGoZAADPBAAANBAAAJkbAAD+BgAA
| YxIAAMgdAAAtCQAAkhQAAPcfAABcCwAABgMAAGsOAADQGQAANQUAAJoQAAD/GwAAZAcAAMkSAAAuHgAAkwkAAPgUAABdAAAA
| wgsAACcXAACMAgAA8Q0AAFYZAAC7BAAAIBAAAIUbAADqBgAATxIAALQdAAAZCQAAfhQAAOMfAABICwAArRYAABICAAB3DQAA
| 3BgAAEEEAACmDwAACxsAAHAGAADVEQAAOh0AAJ8IAAAEFAAAaR8AAM4KAAAzFgAAmAEAAP0MAABiGAAAxwMAACwPAACRGgAA
| 9gUAAFsRAADAHAAAJQgAAIoTAADvHgAAVAoAALkVAAAeAQAAgwwAAOgXAABNAwAAsg4AABcaAAB8BQAA4RAAAEYcAACrBwAA
| EBMAAHUeAADaCQAAPxUAAKQAAAAJDAAAbhcAANMCAAA4DgAAnRkAAAIFAABnEAAAzBsAADEHAACWEgAA+x0AAGAJAADFFAAA
| KgAAAI8LAAD0FgAAWQIAAL4NAAAjGQAAiAQAAO0PAABSGwAAtwYAABwSAACBHQAA5ggAAEsUAACwHwAAFQsAAHoWAADfAQAA
| RA0AAKkYAAAOBAAAcw8AANgaAAA9BgAAohEAAAcdAABsCAAA0RMAADYfAACbCgAAABYAAGUBAADKDAAALxgAAJQDAAD5DgAA
| XhoAAMMFAAAoEQAAjRwAAPIHAABXEwAAvB4AACEKAACGFQAA6wAAAFAMAAC1FwAAGgMAAH8OAADkGQAASQUAAK4QAAATHAAA
| eAcAAN0SAABCHgAApwkAAAwVAABxAAAA1gsAADsXAACgAgAABQ4AAGoZAADPBAAANBAAAJkbAAD+BgAAYxIAAMgdAAAtCQAA
| khQAAPcfAABcCwAAwRYAACYCAACLDQAA8BgAAFUEAAC6DwAAHxsAAIQGAADpEQAATh0AALMIAAAYFAAAfR8AAOIKAABHFgAA
| rAEAABENAAB2GAAA2wMAAEAPAAClGgAACgYAAG8RAADUHAAAOQgAAJ4TAAADHwAAaAoAAM0VAAAyAQAAlwwAAPwXAABhAwAA
| xg4AACsaAACQBQAA9RAAAFocAAC/BwAAJBMAAIkeAADuCQAAUxUAALgAAAAdDAAAghcAAOcCAABMDgAAsRkAABYFAAB7EAAA
| 4BsAAEUHAACqEgAADx4AAHQJAADZFAAAPgAAAKMLAAAIFwAAbQIAANINAAA3GQAAnAQAAAEQAABmGwAAywYAADASAACVHQAA
| +ggAAF8UAADEHwAAKQsAAI4WAADzAQAAWA0AAL0YAAAiBAAAhw8AAOwaAABRBgAAthEAABsdAACACAAA5RMAAEofAACvCgAA
| FBYAAHkBAADeDAAAQxgAAKgDAAANDwAAchoAANcFAAA8EQAAoRwAAEsUAACwHwAAFQsAAHoWAADfAQAARA0AAKkYAAAOBAAA
| cw8AANgaAAA9BgAAohEAAAcdAABsCAAA0RMAADYfAACbCgAAABYAAGUBAADKDAAALxgAAJQDAAD5DgAAXhoAAMMFAAAoEQAA
| jRwAAPIHAABXEwAAvB4AACEKAACGFQAA6wAAAFAMAAC1FwAAGgMAAH8OAADkGQAASQUAAK4QAAATHAAAeAcAAN0SAABCHgAA
| pwkAAAwVAABxAAAA1gsAADsXAACgAgAABQ4AAGoZAADPBAAANBAAAJkbAAD+BgAAYxIAAMgdAAAtCQAAkhQAAPcfAABcCwAA
| wRYAACYCAACLDQAA8BgAAFUEAAC6DwAAHxsAAIQGAADpEQAATh0AALMIAAAYFAAAfR8AAOIKAABHFgAArAEAABENAAB2GAAA
| 2wMAAEAPAAClGgAACgYAAG8RAADUHAAAOQgAAJ4TAAADHwAAaAoAAM0VAAAyAQAAlwwAAPwXAABhAwAAxg4AACsaAACQBQAA
| 9RAAAFocAAC/BwAAJBMAAIkeAADuCQAAUxUAALgAAAAdDAAAghcAAOcCAABMDgAAsRkAABYFAAB7EAAA4BsAAEUHAACqEgAA
| Dx4AAHQJAADZFAAAPgAAAKMLAAAIFwAAbQIAANINAAA3GQAAnAQAAAEQAABmGwAAywYAADASAACVHQAA+ggAAF8UAADEHwAA
| KQsAAI4WAADzAQAAWA0AAL0YAAAiBAAAhw8AAOwaAABRBgAAthEAABsdAACACAAA5RMAAEofAACvCgAAFBYAAHkBAADeDAAA
| QxgAAKgDAAANDwAAchoAANcFAAA8EQAAoRwAAAYIAABrEwAA0B4AADUKAACaFQAA/wAAAGQMAADJFwAALgMAAJMOAAD4GQAA
| XQUAAMIQAAAnHAAAjAcAAPESAABWHgAAuwkAACAVAACFAAAA6gsAAE8XAAC0AgAAGQ4AAH4ZAADjBAAASBAAAK0bAAASBwAA
| dxIAANwdAABBCQAAphQAAAsAAABwCwAA1RYAADoCAACfDQAABBkAAGkEAADODwAAMxsAAJgGAAD9EQAAYh0AAMcIAAAsFAAA
| kR8AAPYKAABbFgAAwAEAACUNAACKGAAA7wMAAFQPAAC5GgAAHgYAAIMRAADoHAAATQgAALITAAAXHwAAfAoAAOEVAABGAQAA
| qwwAABAYAAB1AwAA2g4AAD8aAACkBQAACREAAG4cAADTBwAAOBMAAJ0eAAACCgAAZxUAAMwAAAAxDAAAlhcAAPsCAABgDgAA
| xRkAACoFAACPEAAA9BsAAFkHAAC+EgAAIx4AAIgJAADtFAAAUgAAALcLAAAcFwAAgQIAAOYNAACQBQAA9RAAAFocAAC/BwAA
| JBMAAIkeAADuCQAAUxUAALgAAAAdDAAAghcAAOcCAABMDgAAsRkAABYFAAB7EAAA4BsAAEUHAACqEgAADx4AAHQJAADZFAAA
| PgAAAKMLAAAIFwAAbQIAANINAAA3GQAAnAQAAAEQAABmGwAAywYAADASAACVHQAA+ggAAF8UAADEHwAAKQsAAI4WAADzAQAA
| WA0AAL0YAAAiBAAAhw8AAOwaAABRBgAAthEAABsdAACACAAA5RMAAEofAACvCgAAFBYAAHkBAADeDAAAQxgAAKgDAAANDwAA
| choAANcFAAA8EQAAoRwAAAYIAABrEwAA0B4AADUKAACaFQAA/wAAAGQMAADJFwAALgMAAJMOAAD4GQAAXQUAAMIQAAAnHAAA
| jAcAAPESAABWHgAAuwkAACAVAACFAAAA6gsAAE8XAAC0AgAAGQ4AAH4ZAADjBAAASBAAAK0bAAASBwAAdxIAANwdAABBCQAA
| phQAAAsAAABwCwAA1RYAADoCAACfDQAABBkAAGkEAADODwAAMxsAAJgGAAD9EQAAYh0AAMcIAAAsFAAAkR8AAPYKAABbFgAA
| wAEAACUNAACKGAAA7wMAAFQPAAC5GgAAHgYAAIMRAADoHAAATQgAALITAAAXHwAAfAoAAOEVAABGAQAAqwwAABAYAAB1AwAA
| 2g4AAD8aAACkBQAACREAAG4cAADTBwAAOBMAAJ0eAAACCgAAZxUAAMwAAAAxDAAAlhcAAPsCAABgDgAAxRkAACoFAACPEAAA
| 9BsAAFkHAAC+EgAAIx4AAIgJAADtFAAAUgAAALcLAAAcFwAAgQIAAOYNAABLGQAAsAQAABUQAAB6GwAA3wYAAEQSAACpHQAA
| DgkAAHMUAADYHwAAPQsAAKIWAAAHAgAAbA0AANEYAAA2BAAAmw8AAAAbAABlBgAAyhEAAC8dAACUCAAA+RMAAF4fAADDCgAA
| KBYAAI0BAADyDAAAVxgAALwDAAAhDwAAhhoAAOsFAABQEQAAtRwAABoIAAB/EwAA5B4AAEkKAACuFQAAEwEAAHgMAADdFwAA
| QgMAAKcOAAAMGgAAcQUAANYQAAA7HAAAoAcAAAUTAABqHgAAzwkAADQVAACZAAAA/gsAAGMXAADIAgAALQ4AAJIZAAD3BAAA
| XBAAAMEbAAAmBwAAixIAAPAdAABVCQAAuhQAAB8AAACECwAA6RYAAE4CAACzDQAAGBkAAH0EAADiDwAARxsAAKwGAAAREgAA
| dh0AANsIAABAFAAApR8AAAoLAABvFgAA1AEAADkNAACeGAAAAwQAAGgPAADNGgAAMgYAAJcRAAD8HAAAYQgAAMYTAAArHwAA
| 1RYAADoCAACfDQAABBkAAGkEAADODwAAMxsAAJgGAAD9EQAAYh0AAMcIAAAsFAAAkR8AAPYKAABbFgAAwAEAACUNAACKGAAA
| 7wMAAFQPAAC5GgAAHgYAAIMRAADoHAAATQgAALITAAAXHwAAfAoAAOEVAABGAQAAqwwAABAYAAB1AwAA2g4AAD8aAACkBQAA
| CREAAG4cAADTBwAAOBMAAJ0eAAACCgAAZxUAAMwAAAAxDAAAlhcAAPsCAABgDgAAxRkAACoFAACPEAAA9BsAAFkHAAC+EgAA
| Ix4AAIgJAADtFAAAUgAAALcLAAAcFwAAgQIAAOYNAABLGQAAsAQAABUQAAB6GwAA3wYAAEQSAACpHQAADgkAAHMUAADYHwAA
| PQsAAKIWAAAHAgAAbA0AANEYAAA2BAAAmw8AAAAbAABlBgAAyhEAAC8dAACUCAAA+RMAAF4fAADDCgAAKBYAAI0BAADyDAAA
| VxgAALwDAAAhDwAAhhoAAOsFAABQEQAAtRwAABoIAAB/EwAA5B4AAEkKAACuFQAAEwEAAHgMAADdFwAAQgMAAKcOAAAMGgAA
| cQUAANYQAAA7HAAAoAcAAAUTAABqHgAAzwkAADQVAACZAAAA/gsAAGMXAADIAgAALQ4AAJIZAAD3BAAAXBAAAMEbAAAmBwAA
| ixIAAPAdAABVCQAAuhQAAB8AAACECwAA6RYAAE4CAACzDQAAGBkAAH0EAADiDwAARxsAAKwGAAAREgAAdh0AANsIAABAFAAA
| pR8AAAoLAABvFgAA1AEAADkNAACeGAAAAwQAAGgPAADNGgAAMgYAAJcRAAD8HAAAYQgAAMYTAAArHwAAkAoAAPUVAABaAQAA
| vwwAACQYAACJAwAA7g4AAFMaAAC4BQAAHREAAIIcAADnBwAATBMAALEeAAAWCgAAexUAAOAAAABFDAAAqhcAAA8DAAB0DgAA
| 2RkAAD4FAACjEAAACBwAAG0HAADSEgAANx4AAJwJAAABFQAAZgAAAMsLAAAwFwAAlQIAAPoNAABfGQAAxAQAACkQAACOGwAA
| 8wYAAFgSAAC9HQAAIgkAAIcUAADsHwAAUQsAALYWAAAbAgAAgA0AAOUYAABKBAAArw8AABQbAAB5BgAA3hEAAEMdAACoCAAA
| DRQAAHIfAADXCgAAPBYAAKEBAAAGDQAAaxgAANADAAA1DwAAmhoAAP8FAABkEQAAyRwAAC4IAACTEwAA+B4AAF0KAADCFQAA
| JwEAAIwMAADxFwAAVgMAALsOAAAgGgAAhQUAAOoQAABPHAAAtAcAABkTAAB+HgAA4wkAAEgVAACtAAAAEgwAAHcXAADcAgAA
| QQ4AAKYZAAALBQAAcBAAABoIAAB/EwAA5B4AAEkKAACuFQAAEwEAAHgMAADdFwAAQgMAAKcOAAAMGgAAcQUAANYQAAA7HAAA
| oAcAAAUTAABqHgAAzwkAADQVAACZAAAA/gsAAGMXAADIAgAALQ4AAJIZAAD3BAAAXBAAAMEbAAAmBwAAixIAAPAdAABVCQAA
| uhQAAB8AAACECwAA6RYAAE4CAACzDQAAGBkAAH0EAADiDwAARxsAAKwGAAAREgAAdh0AANsIAABAFAAApR8AAAoLAABvFgAA
| 1AEAADkNAACeGAAAAwQAAGgPAADNGgAAMgYAAJcRAAD8HAAAYQgAAMYTAAArHwAAkAoAAPUVAABaAQAAvwwAACQYAACJAwAA
| 7g4AAFMaAAC4BQAAHREAAIIcAADnBwAATBMAALEeAAAWCgAAexUAAOAAAABFDAAAqhcAAA8DAAB0DgAA2RkAAD4FAACjEAAA
| CBwAAG0HAADSEgAANx4AAJwJAAABFQAAZgAAAMsLAAAwFwAAlQIAAPoNAABfGQAAxAQAACkQAACOGwAA8wYAAFgSAAC9HQAA
| IgkAAIcUAADsHwAAUQsAALYWAAAbAgAAgA0AAOUYAABKBAAArw8AABQbAAB5BgAA3hEAAEMdAACoCAAADRQAAHIfAADXCgAA
| PBYAAKEBAAAGDQAAaxgAANADAAA1DwAAmhoAAP8FAABkEQAAyRwAAC4IAACTEwAA+B4AAF0KAADCFQAAJwEAAIwMAADxFwAA
| VgMAALsOAAAgGgAAhQUAAOoQAABPHAAAtAcAABkTAAB+HgAA4wkAAEgVAACtAAAAEgwAAHcXAADcAgAAQQ4AAKYZAAALBQAA
| cBAAANUbAAA6BwAAnxIAAAQeAABpCQAAzhQAADMAAACYCwAA/RYAAGICAADHDQAALBkAAJEEAAD2DwAAWxsAAMAGAAAlEgAA
| ih0AAO8IAABUFAAAuR8AAB4LAACDFgAA6AEAAE0NAACyGAAAFwQAAHwPAADhGgAARgYAAKsRAAAQHQAAdQgAANoTAAA/HwAA
| pAoAAAkWAABuAQAA0wwAADgYAACdAwAAAg8AAGcaAADMBQAAMREAAJYcAAD7BwAAYBMAAMUeAAAqCgAAjxUAAPQAAABZDAAA
| vhcAACMDAACIDgAA7RkAAFIFAAC3EAAAHBwAAIEHAADmEgAASx4AALAJAAAVFQAAegAAAN8LAABEFwAAqQIAAA4OAABzGQAA
| 2AQAAD0QAACiGwAABwcAAGwSAADRHQAANgkAAJsUAAAAAAAAZQsAAMoWAAAvAgAAlA0AAPkYAABeBAAAww8AACgbAACNBgAA
| 8hEAAFcdAAC8CAAAIRQAAIYfAADrCgAAUBYAALUBAABfGQAAxAQAACkQAACOGwAA8wYAAFgSAAC9HQAAIgkAAIcUAADsHwAA
| UQsAALYWAAAbAgAAgA0AAOUYAABKBAAArw8AABQbAAB5BgAA3hEAAEMdAACoCAAADRQAAHIfAADXCgAAPBYAAKEBAAAGDQAA
| axgAANADAAA1DwAAmhoAAP8FAABkEQAAyRwAAC4IAACTEwAA+B4AAF0KAADCFQAAJwEAAIwMAADxFwAAVgMAALsOAAAgGgAA
| hQUAAOoQAABPHAAAtAcAABkTAAB+HgAA4wkAAEgVAACtAAAAEgwAAHcXAADcAgAAQQ4AAKYZAAALBQAAcBAAANUbAAA6BwAA
| nxIAAAQeAABpCQAAzhQAADMAAACYCwAA/RYAAGICAADHDQAALBkAAJEEAAD2DwAAWxsAAMAGAAAlEgAAih0AAO8IAABUFAAA
| uR8AAB4LAACDFgAA6AEAAE0NAACyGAAAFwQAAHwPAADhGgAARgYAAKsRAAAQHQAAdQgAANoTAAA/HwAApAoAAAkWAABuAQAA
| 0wwAADgYAACdAwAAAg8AAGcaAADMBQAAMREAAJYcAAD7BwAAYBMAAMUeAAAqCgAAjxUAAPQAAABZDAAAvhcAACMDAACIDgAA
| 7RkAAFIFAAC3EAAAHBwAAIEHAADmEgAASx4AALAJAAAVFQAAegAAAN8LAABEFwAAqQIAAA4OAABzGQAA2AQAAD0QAACiGwAA
| BwcAAGwSAADRHQAANgkAAJsUAAAAAAAAZQsAAMoWAAAvAgAAlA0AAPkYAABeBAAAww8AACgbAACNBgAA8hEAAFcdAAC8CAAA
| IRQAAIYfAADrCgAAUBYAALUBAAAaDQAAfxgAAOQDAABJDwAArhoAABMGAAB4EQAA3RwAAEIIAACnEwAADB8AAHEKAADWFQAA
| OwEAAKAMAAAFGAAAagMAAM8OAAA0GgAAmQUAAP4QAABjHAAAyAcAAC0TAACSHgAA9wkAAFwVAADBAAAAJgwAAIsXAADwAgAA
| VQ4AALoZAAAfBQAAhBAAAOkbAABOBwAAsxIAABgeAAB9CQAA4hQAAEcAAACsCwAAERcAAHYCAADbDQAAQBkAAKUEAAAKEAAA
| bxsAANQGAAA5EgAAnh0AAAMJAABoFAAAzR8AADILAACXFgAA/AEAAGENAADGGAAAKwQAAJAPAAD1GgAAWgYAAL8RAAAkHQAA
| iQgAAO4TAABTHwAAuAoAAB0WAACCAQAA5wwAAEwYAACxAwAAFg8AAHsaAADgBQAARREAAKocAAAPCAAAdBMAANkeAAA+CgAA
| oxUAAAgBAABtDAAA0hcAADcDAACcDgAAARoAAGYFAADLEAAAMBwAAJUHAAD6EgAApAoAAAkWAABuAQAA0wwAADgYAACdAwAA
| Ag8AAGcaAADMBQAAMREAAJYcAAD7BwAAYBMAAMUeAAAqCgAAjxUAAPQAAABZDAAAvhcAACMDAACIDgAA7RkAAFIFAAC3EAAA
| HBwAAIEHAADmEgAASx4AALAJAAAVFQAAegAAAN8LAABEFwAAqQIAAA4OAABzGQAA2AQAAD0QAACiGwAABwcAAGwSAADRHQAA
| NgkAAJsUAAAAAAAAZQsAAMoWAAAvAgAAlA0AAPkYAABeBAAAww8AACgbAACNBgAA8hEAAFcdAAC8CAAAIRQAAIYfAADrCgAA
| UBYAALUBAAAaDQAAfxgAAOQDAABJDwAArhoAABMGAAB4EQAA3RwAAEIIAACnEwAADB8AAHEKAADWFQAAOwEAAKAMAAAFGAAA
| agMAAM8OAAA0GgAAmQUAAP4QAABjHAAAyAcAAC0TAACSHgAA9wkAAFwVAADBAAAAJgwAAIsXAADwAgAAVQ4AALoZAAAfBQAA
| hBAAAOkbAABOBwAAsxIAABgeAAB9CQAA4hQAAEcAAACsCwAAERcAAHYCAADbDQAAQBkAAKUEAAAKEAAAbxsAANQGAAA5EgAA
| nh0AAAMJAABoFAAAzR8AADILAACXFgAA/AEAAGENAADGGAAAKwQAAJAPAAD1GgAAWgYAAL8RAAAkHQAAiQgAAO4TAABTHwAA
| uAoAAB0WAACCAQAA5wwAAEwYAACxAwAAFg8AAHsaAADgBQAARREAAKocAAAPCAAAdBMAANkeAAA+CgAAoxUAAAgBAABtDAAA
| 0hcAADcDAACcDgAAARoAAGYFAADLEAAAMBwAAJUHAAD6EgAAXx4AAMQJAAApFQAAjgAAAPMLAABYFwAAvQIAACIOAACHGQAA
| 7AQAAFEQAAC2GwAAGwcAAIASAADlHQAASgkAAK8UAAAUAAAAeQsAAN4WAABDAgAAqA0AAA0ZAAByBAAA1w8AADwbAAChBgAA
| BhIAAGsdAADQCAAANRQAAJofAAD/CgAAZBYAAMkBAAAuDQAAkxgAAPgDAABdDwAAwhoAACcGAACMEQAA8RwAAFYIAAC7EwAA
| IB8AAIUKAADqFQAATwEAALQMAAAZGAAAfgMAAOMOAABIGgAArQUAABIRAAB3HAAA3AcAAEETAACmHgAACwoAAHAVAADVAAAA
| OgwAAJ8XAAAEAwAAaQ4AAM4ZAAAzBQAAmBAAAP0bAABiBwAAxxIAACweAACRCQAA9hQAAFsAAADACwAAJRcAAIoCAADvDQAA
| VBkAALkEAAAeEAAAgxsAAOgGAABNEgAAsh0AABcJAAB8FAAA4R8AAEYLAACrFgAAEAIAAHUNAADaGAAAPwQAAOkbAABOBwAA
| sxIAABgeAAB9CQAA4hQAAEcAAACsCwAAERcAAHYCAADbDQAAQBkAAKUEAAAKEAAAbxsAANQGAAA5EgAAnh0AAAMJAABoFAAA
| zR8AADILAACXFgAA/AEAAGENAADGGAAAKwQAAJAPAAD1GgAAWgYAAL8RAAAkHQAAiQgAAO4TAABTHwAAuAoAAB0WAACCAQAA
| 5wwAAEwYAACxAwAAFg8AAHsaAADgBQAARREAAKocAAAPCAAAdBMAANkeAAA+CgAAoxUAAAgBAABtDAAA0hcAADcDAACcDgAA
| ARoAAGYFAADLEAAAMBwAAJUHAAD6EgAAXx4AAMQJAAApFQAAjgAAAPMLAABYFwAAvQIAACIOAACHGQAA7AQAAFEQAAC2GwAA
| GwcAAIASAADlHQAASgkAAK8UAAAUAAAAeQsAAN4WAABDAgAAqA0AAA0ZAAByBAAA1w8AADwbAAChBgAABhIAAGsdAADQCAAA
| NRQAAJofAAD/CgAAZBYAAMkBAAAuDQAAkxgAAPgDAABdDwAAwhoAACcGAACMEQAA8RwAAFYIAAC7EwAAIB8AAIUKAADqFQAA
| TwEAALQMAAAZGAAAfgMAAOMOAABIGgAArQUAABIRAAB3HAAA3AcAAEETAACmHgAACwoAAHAVAADVAAAAOgwAAJ8XAAAEAwAA
| aQ4AAM4ZAAAzBQAAmBAAAP0bAABiBwAAxxIAACweAACRCQAA9hQAAFsAAADACwAAJRcAAIoCAADvDQAAVBkAALkEAAAeEAAA
| gxsAAOgGAABNEgAAsh0AABcJAAB8FAAA4R8AAEYLAACrFgAAEAIAAHUNAADaGAAAPwQAAKQPAAAJGwAAbgYAANMRAAA4HQAA
| nQgAAAIUAABnHwAAzAoAADEWAACWAQAA+wwAAGAYAADFAwAAKg8AAI8aAAD0BQAAWREAAL4cAAAjCAAAiBMAAO0eAABSCgAA
| txUAABwBAACBDAAA5hcAAEsDAACwDgAAFRoAAHoFAADfEAAARBwAAKkHAAAOEwAAcx4AANgJAAA9FQAAogAAAAcMAABsFwAA
| 0QIAADYOAACbGQAAAAUAAGUQAADKGwAALwcAAJQSAAD5HQAAXgkAAMMUAAAoAAAAjQsAAPIWAABXAgAAvA0AACEZAACGBAAA
| 6w8AAFAbAAC1BgAAGhIAAH8dAADkCAAASRQAAK4fAAATCwAAeBYAAN0BAABCDQAApxgAAAwEAABxDwAA1hoAADsGAACgEQAA
| BR0AAGoIAADPEwAANB8AAJkKAAD+FQAAYwEAAMgMAAAtGAAAkgMAAPcOAABcGgAAwQUAACYRAACLHAAA8AcAAFUTAAC6HgAA
| HwoAAIQVAAAuDQAAkxgAAPgDAABdDwAAwhoAACcGAACMEQAA8RwAAFYIAAC7EwAAIB8AAIUKAADqFQAATwEAALQMAAAZGAAA
| fgMAAOMOAABIGgAArQUAABIRAAB3HAAA3AcAAEETAACmHgAACwoAAHAVAADVAAAAOgwAAJ8XAAAEAwAAaQ4AAM4ZAAAzBQAA
| mBAAAP0bAABiBwAAxxIAACweAACRCQAA9hQAAFsAAADACwAAJRcAAIoCAADvDQAAVBkAALkEAAAeEAAAgxsAAOgGAABNEgAA
| sh0AABcJAAB8FAAA4R8AAEYLAACrFgAAEAIAAHUNAADaGAAAPwQAAKQPAAAJGwAAbgYAANMRAAA4HQAAnQgAAAIUAABnHwAA
| zAoAADEWAACWAQAA+wwAAGAYAADFAwAAKg8AAI8aAAD0BQAAWREAAL4cAAAjCAAAiBMAAO0eAABSCgAAtxUAABwBAACBDAAA
| 5hcAAEsDAACwDgAAFRoAAHoFAADfEAAARBwAAKkHAAAOEwAAcx4AANgJAAA9FQAAogAAAAcMAABsFwAA0QIAADYOAACbGQAA
| AAUAAGUQAADKGwAALwcAAJQSAAD5HQAAXgkAAMMUAAAoAAAAjQsAAPIWAABXAgAAvA0AACEZAACGBAAA6w8AAFAbAAC1BgAA
| GhIAAH8dAADkCAAASRQAAK4fAAATCwAAeBYAAN0BAABCDQAApxgAAAwEAABxDwAA1hoAADsGAACgEQAABR0AAGoIAADPEwAA
| NB8AAJkKAAD+FQAAYwEAAMgMAAAtGAAAkgMAAPcOAABcGgAAwQUAACYRAACLHAAA8AcAAFUTAAC6HgAAHwoAAIQVAADpAAAA
| TgwAALMXAAAYAwAAfQ4AAOIZAABHBQAArBAAABEcAAB2BwAA2xIAAEAeAAClCQAAChUAAG8AAADUCwAAORcAAJ4CAAADDgAA
| aBkAAM0EAAAyEAAAlxsAAPwGAABhEgAAxh0AACsJAACQFAAA9R8AAFoLAAC/FgAAJAIAAIkNAADuGAAAUwQAALgPAAAdGwAA
| ggYAAOcRAABMHQAAsQgAABYUAAB7HwAA4AoAAEUWAACqAQAADw0AAHQYAADZAwAAPg8AAKMaAAAIBgAAbREAANIcAAA3CAAA
| nBMAAAEfAABmCgAAyxUAADABAACVDAAA+hcAAF8DAADEDgAAKRoAAI4FAADzEAAAWBwAAL0HAAAiEwAAhx4AAOwJAABRFQAA
| tgAAABsMAACAFwAA5QIAAEoOAACvGQAAFAUAAHkQAADeGwAAQwcAAKgSAAANHgAAcgkAANcUAAA8AAAAoQsAAAYXAABrAgAA
| 0A0AADUZAACaBAAA/w8AAGQbAADJBgAAcx4AANgJAAA9FQAAogAAAAcMAABsFwAA0QIAADYOAACbGQAAAAUAAGUQAADKGwAA
| LwcAAJQSAAD5HQAAXgkAAMMUAAAoAAAAjQsAAPIWAABXAgAAvA0AACEZAACGBAAA6w8AAFAbAAC1BgAAGhIAAH8dAADkCAAA
| SRQAAK4fAAATCwAAeBYAAN0BAABCDQAApxgAAAwEAABxDwAA1hoAADsGAACgEQAABR0AAGoIAADPEwAANB8AAJkKAAD+FQAA
| YwEAAMgMAAAtGAAAkgMAAPcOAABcGgAAwQUAACYRAACLHAAA8AcAAFUTAAC6HgAAHwoAAIQVAADpAAAATgwAALMXAAAYAwAA
| fQ4AAOIZAABHBQAArBAAABEcAAB2BwAA2xIAAEAeAAClCQAAChUAAG8AAADUCwAAORcAAJ4CAAADDgAAaBkAAM0EAAAyEAAA
| lxsAAPwGAABhEgAAxh0AACsJAACQFAAA9R8AAFoLAAC/FgAAJAIAAIkNAADuGAAAUwQAALgPAAAdGwAAggYAAOcRAABMHQAA
| sQgAABYUAAB7HwAA4AoAAEUWAACqAQAADw0AAHQYAADZAwAAPg8AAKMaAAAIBgAAbREAANIcAAA3CAAAnBMAAAEfAABmCgAA
| yxUAADABAACVDAAA+hcAAF8DAADEDgAAKRoAAI4FAADzEAAAWBwAAL0HAAAiEwAAhx4AAOwJAABRFQAAtgAAABsMAACAFwAA
| 5QIAAEoOAACvGQAAFAUAAHkQAADeGwAAQwcAAKgSAAANHgAAcgkAANcUAAA8AAAAoQsAAAYXAABrAgAA0A0AADUZAACaBAAA
| /w8AAGQbAADJBgAALhIAAJMdAAD4CAAAXRQAAMIfAAAnCwAAjBYAAPEBAABWDQAAuxgAACAEAACFDwAA6hoAAE8GAAC0EQAA
| GR0AAH4IAADjEwAASB8AAK0KAAASFgAAdwEAANwMAABBGAAApgMAAAsPAABwGgAA1QUAADoRAACfHAAABAgAAGkTAADOHgAA
| MwoAAJgVAAD9AAAAYgwAAMcXAAAsAwAAkQ4AAPYZAABbBQAAwBAAACUcAACKBwAA7xIAAFQeAAC5CQAAHhUAAIMAAADoCwAA
| TRcAALICAAAXDgAAfBkAAOEEAABGEAAAqxsAABAHAAB1EgAA2h0AAD8JAACkFAAACQAAAG4LAADTFgAAOAIAAJ0NAAACGQAA
| ZwQAAMwPAAAxGwAAlgYAAPsRAABgHQAAxQgAACoUAACPHwAA9AoAAFkWAAC+AQAAIw0AAIgYAADtAwAAUg8AALcaAAAcBgAA
| gREAAOYcAABLCAAAsBMAABUfAAB6CgAA3xUAAEQBAACpDAAADhgAALgPAAAdGwAAggYAAOcRAABMHQAAsQgAABYUAAB7HwAA
| 4AoAAEUWAACqAQAADw0AAHQYAADZAwAAPg8AAKMaAAAIBgAAbREAANIcAAA3CAAAnBMAAAEfAABmCgAAyxUAADABAACVDAAA
| +hcAAF8DAADEDgAAKRoAAI4FAADzEAAAWBwAAL0HAAAiEwAAhx4AAOwJAABRFQAAtgAAABsMAACAFwAA5QIAAEoOAACvGQAA
| FAUAAHkQAADeGwAAQwcAAKgSAAANHgAAcgkAANcUAAA8AAAAoQsAAAYXAABrAgAA0A0AADUZAACaBAAA/w8AAGQbAADJBgAA
| LhIAAJMdAAD4CAAAXRQAAMIfAAAnCwAAjBYAAPEBAABWDQAAuxgAACAEAACFDwAA6hoAAE8GAAC0EQAAGR0AAH4IAADjEwAA
| SB8AAK0KAAASFgAAdwEAANwMAABBGAAApgMAAAsPAABwGgAA1QUAADoRAACfHAAABAgAAGkTAADOHgAAMwoAAJgVAAD9AAAA
| YgwAAMcXAAAsAwAAkQ4AAPYZAABbBQAAwBAAACUcAACKBwAA7xIAAFQeAAC5CQAAHhUAAIMAAADoCwAATRcAALICAAAXDgAA
| fBkAAOEEAABGEAAAqxsAABAHAAB1EgAA2h0AAD8JAACkFAAACQAAAG4LAADTFgAAOAIAAJ0NAAACGQAAZwQAAMwPAAAxGwAA
| lgYAAPsRAABgHQAAxQgAACoUAACPHwAA9AoAAFkWAAC+AQAAIw0AAIgYAADtAwAAUg8AALcaAAAcBgAAgREAAOYcAABLCAAA
| sBMAABUfAAB6CgAA3xUAAEQBAACpDAAADhgAAHMDAADYDgAAPRoAAKIFAAAHEQAAbBwAANEHAAA2EwAAmx4AAAAKAABlFQAA
| ygAAAC8MAACUFwAA+QIAAF4OAADDGQAAKAUAAI0QAADyGwAAVwcAALwSAAAhHgAAhgkAAOsUAABQAAAAtQsAABoXAAB/AgAA
| 5A0AAEkZAACuBAAAExAAAHgbAADdBgAAQhIAAKcdAAAMCQAAcRQAANYfAAA7CwAAoBYAAAUCAABqDQAAzxgAADQEAACZDwAA
| /hoAAGMGAADIEQAALR0AAJIIAAD3EwAAXB8AAMEKAAAmFgAAiwEAAPAMAABVGAAAugMAAB8PAACEGgAA6QUAAE4RAACzHAAA
| GAgAAH0TAADiHgAARwoAAKwVAAARAQAAdgwAANsXAABAAwAApQ4AAAoaAABvBQAA1BAAADkcAACeBwAAAxMAAGgeAADNCQAA
| MhUAAJcAAAD8CwAAYRcAAMYCAAArDgAAkBkAAPUEAABaEAAAvxsAACQHAACJEgAA7h0AAFMJAAD9AAAAYgwAAMcXAAAsAwAA
| kQ4AAPYZAABbBQAAwBAAACUcAACKBwAA7xIAAFQeAAC5CQAAHhUAAIMAAADoCwAATRcAALICAAAXDgAAfBkAAOEEAABGEAAA
| qxsAABAHAAB1EgAA2h0AAD8JAACkFAAACQAAAG4LAADTFgAAOAIAAJ0NAAACGQAAZwQAAMwPAAAxGwAAlgYAAPsRAABgHQAA
| xQgAACoUAACPHwAA9AoAAFkWAAC+AQAAIw0AAIgYAADtAwAAUg8AALcaAAAcBgAAgREAAOYcAABLCAAAsBMAABUfAAB6CgAA
| 3xUAAEQBAACpDAAADhgAAHMDAADYDgAAPRoAAKIFAAAHEQAAbBwAANEHAAA2EwAAmx4AAAAKAABlFQAAygAAAC8MAACUFwAA
| +QIAAF4OAADDGQAAKAUAAI0QAADyGwAAVwcAALwSAAAhHgAAhgkAAOsUAABQAAAAtQsAABoXAAB/AgAA5A0AAEkZAACuBAAA
| ExAAAHgbAADdBgAAQhIAAKcdAAAMCQAAcRQAANYfAAA7CwAAoBYAAAUCAABqDQAAzxgAADQEAACZDwAA/hoAAGMGAADIEQAA
| LR0AAJIIAAD3EwAAXB8AAMEKAAAmFgAAiwEAAPAMAABVGAAAugMAAB8PAACEGgAA6QUAAE4RAACzHAAAGAgAAH0TAADiHgAA
| RwoAAKwVAAARAQAAdgwAANsXAABAAwAApQ4AAAoaAABvBQAA1BAAADkcAACeBwAAAxMAAGgeAADNCQAAMhUAAJcAAAD8CwAA
| YRcAAMYCAAArDgAAkBkAAPUEAABaEAAAvxsAACQHAACJEgAA7h0AAFMJAAC4FAAAHQAAAIILAADnFgAATAIAALENAAAWGQAA
| ewQAAOAPAABFGwAAqgYAAA8SAAB0HQAA2QgAAD4UAACjHwAACAsAAG0WAADSAQAANw0AAJwYAAABBAAAZg8AAMsaAAAwBgAA
| lREAAPocAABfCAAAxBMAACkfAACOCgAA8xUAAFgBAAC9DAAAIhgAAIcDAADsDgAAURoAALYFAAAbEQAAgBwAAOUHAABKEwAA
| rx4AABQKAAB5FQAA3gAAAEMMAACoFwAADQMAAHIOAADXGQAAPAUAAKEQAAAGHAAAawcAANASAAA1HgAAmgkAAP8UAABkAAAA
| yQsAAC4XAACTAgAA+A0AAF0ZAADCBAAAJxAAAIwbAADxBgAAVhIAALsdAAAgCQAAhRQAAOofAABPCwAAtBYAABkCAAB+DQAA
| 4xgAAEgEAACtDwAAEhsAAHcGAADcEQAAQR0AAKYIAAALFAAAcB8AANUKAAA6FgAAnwEAAAQNAABpGAAAzgMAADMPAACYGgAA
| QhIAAKcdAAAMCQAAcRQAANYfAAA7CwAAoBYAAAUCAABqDQAAzxgAADQEAACZDwAA/hoAAGMGAADIEQAALR0AAJIIAAD3EwAA
| XB8AAMEKAAAmFgAAiwEAAPAMAABVGAAAugMAAB8PAACEGgAA6QUAAE4RAACzHAAAGAgAAH0TAADiHgAARwoAAKwVAAARAQAA
| dgwAANsXAABAAwAApQ4AAAoaAABvBQAA1BAAADkcAACeBwAAAxMAAGgeAADNCQAAMhUAAJcAAAD8CwAAYRcAAMYCAAArDgAA
| kBkAAPUEAABaEAAAvxsAACQHAACJEgAA7h0AAFMJAAC4FAAAHQAAAIILAADnFgAATAIAALENAAAWGQAAewQAAOAPAABFGwAA
| qgYAAA8SAAB0HQAA2QgAAD4UAACjHwAACAsAAG0WAADSAQAANw0AAJwYAAABBAAAZg8AAMsaAAAwBgAAlREAAPocAABfCAAA
| xBMAACkfAACOCgAA8xUAAFgBAAC9DAAAIhgAAIcDAADsDgAAURoAALYFAAAbEQAAgBwAAOUHAABKEwAArx4AABQKAAB5FQAA
| 3gAAAEMMAACoFwAADQMAAHIOAADXGQAAPAUAAKEQAAAGHAAAawcAANASAAA1HgAAmgkAAP8UAABkAAAAyQsAAC4XAACTAgAA
| +A0AAF0ZAADCBAAAJxAAAIwbAADxBgAAVhIAALsdAAAgCQAAhRQAAOofAABPCwAAtBYAABkCAAB+DQAA4xgAAEgEAACtDwAA
| EhsAAHcGAADcEQAAQR0AAKYIAAALFAAAcB8AANUKAAA6FgAAnwEAAAQNAABpGAAAzgMAADMPAACYGgAA/QUAAGIRAADHHAAA
| LAgAAJETAAD2HgAAWwoAAMAVAAAlAQAAigwAAO8XAABUAwAAuQ4AAB4aAACDBQAA6BAAAE0cAACyBwAAFxMAAHweAADhCQAA
| RhUAAKsAAAAQDAAAdRcAANoCAAA/DgAApBkAAAkFAABuEAAA0xsAADgHAACdEgAAAh4AAGcJAADMFAAAMQAAAJYLAAD7FgAA
| YAIAAMUNAAAqGQAAjwQAAPQPAABZGwAAvgYAACMSAACIHQAA7QgAAFIUAAC3HwAAHAsAAIEWAADmAQAASw0AALAYAAAVBAAA
| eg8AAN8aAABEBgAAqREAAA4dAABzCAAA2BMAAD0fAACiCgAABxYAAGwBAADRDAAANhgAAJsDAAAADwAAZRoAAMoFAAAvEQAA
| lBwAAPkHAABeEwAAwx4AACgKAACNFQAA8gAAAFcMAAC8FwAAIQMAAIYOAADrGQAAUAUAALUQAAAaHAAAfwcAAOQSAABJHgAA
| rgkAABMVAAB4AAAA3QsAAIcDAADsDgAAURoAALYFAAAbEQAAgBwAAOUHAABKEwAArx4AABQKAAB5FQAA3gAAAEMMAACoFwAA
| DQMAAHIOAADXGQAAPAUAAKEQAAAGHAAAawcAANASAAA1HgAAmgkAAP8UAABkAAAAyQsAAC4XAACTAgAA+A0AAF0ZAADCBAAA
| JxAAAIwbAADxBgAAVhIAALsdAAAgCQAAhRQAAOofAABPCwAAtBYAABkCAAB+DQAA4xgAAEgEAACtDwAAEhsAAHcGAADcEQAA
| QR0AAKYIAAALFAAAcB8AANUKAAA6FgAAnwEAAAQNAABpGAAAzgMAADMPAACYGgAA/QUAAGIRAADHHAAALAgAAJETAAD2HgAA
| WwoAAMAVAAAlAQAAigwAAO8XAABUAwAAuQ4AAB4aAACDBQAA6BAAAE0cAACyBwAAFxMAAHweAADhCQAARhUAAKsAAAAQDAAA
| dRcAANoCAAA/DgAApBkAAAkFAABuEAAA0xsAADgHAACdEgAAAh4AAGcJAADMFAAAMQAAAJYLAAD7FgAAYAIAAMUNAAAqGQAA
| jwQAAPQPAABZGwAAvgYAACMSAACIHQAA7QgAAFIUAAC3HwAAHAsAAIEWAADmAQAASw0AALAYAAAVBAAAeg8AAN8aAABEBgAA
| qREAAA4dAABzCAAA2BMAAD0fAACiCgAABxYAAGwBAADRDAAANhgAAJsDAAAADwAAZRoAAMoFAAAvEQAAlBwAAPkHAABeEwAA
| wx4AACgKAACNFQAA8gAAAFcMAAC8FwAAIQMAAIYOAADrGQAAUAUAALUQAAAaHAAAfwcAAOQSAABJHgAArgkAABMVAAB4AAAA
| 3QsAAEIXAACnAgAADA4AAHEZAADWBAAAOxAAAKAbAAAFBwAAahIAAM8dAAA0CQAAmRQAAP4fAABjCwAAyBYAAC0CAACSDQAA
| 9xgAAFwEAADBDwAAJhsAAIsGAADwEQAAVR0AALoIAAAfFAAAhB8AAOkKAABOFgAAswEAABgNAAB9GAAA4gMAAEcPAACsGgAA
| EQYAAHYRAADbHAAAQAgAAKUTAAAKHwAAbwoAANQVAAA5AQAAngwAAAMYAABoAwAAzQ4AADIaAACXBQAA/BAAAGEcAADGBwAA
| KxMAAJAeAAD1CQAAWhUAAL8AAAAkDAAAiRcAAO4CAABTDgAAuBkAAB0FAACCEAAA5xsAAEwHAACxEgAAFh4AAHsJAADgFAAA
| RQAAAKoLAAAPFwAAdAIAANkNAAA+GQAAowQAAAgQAABtGwAA0gYAADcSAACcHQAAAQkAAGYUAADLHwAAMAsAAJUWAAD6AQAA
| Xw0AAMQYAAApBAAAjg8AAPMaAABYBgAAvREAACIdAADMFAAAMQAAAJYLAAD7FgAAYAIAAMUNAAAqGQAAjwQAAPQPAABZGwAA
| vgYAACMSAACIHQAA7QgAAFIUAAC3HwAAHAsAAIEWAADmAQAASw0AALAYAAAVBAAAeg8AAN8aAABEBgAAqREAAA4dAABzCAAA
| 2BMAAD0fAACiCgAABxYAAGwBAADRDAAANhgAAJsDAAAADwAAZRoAAMoFAAAvEQAAlBwAAPkHAABeEwAAwx4AACgKAACNFQAA
| 8gAAAFcMAAC8FwAAIQMAAIYOAADrGQAAUAUAALUQAAAaHAAAfwcAAOQSAABJHgAArgkAABMVAAB4AAAA3QsAAEIXAACnAgAA
| DA4AAHEZAADWBAAAOxAAAKAbAAAFBwAAahIAAM8dAAA0CQAAmRQAAP4fAABjCwAAyBYAAC0CAACSDQAA9xgAAFwEAADBDwAA
| JhsAAIsGAADwEQAAVR0AALoIAAAfFAAAhB8AAOkKAABOFgAAswEAABgNAAB9GAAA4gMAAEcPAACsGgAAEQYAAHYRAADbHAAA
| QAgAAKUTAAAKHwAAbwoAANQVAAA5AQAAngwAAAMYAABoAwAAzQ4AADIaAACXBQAA/BAAAGEcAADGBwAAKxMAAJAeAAD1CQAA
| WhUAAL8AAAAkDAAAiRcAAO4CAABTDgAAuBkAAB0FAACCEAAA5xsAAEwHAACxEgAAFh4AAHsJAADgFAAARQAAAKoLAAAPFwAA
| dAIAANkNAAA+GQAAowQAAAgQAABtGwAA0gYAADcSAACcHQAAAQkAAGYUAADLHwAAMAsAAJUWAAD6AQAAXw0AAMQYAAApBAAA
| jg8AAPMaAABYBgAAvREAACIdAACHCAAA7BMAAFEfAAC2CgAAGxYAAIABAADlDAAAShgAAK8DAAAUDwAAeRoAAN4FAABDEQAA
| qBwAAA0IAAByEwAA1x4AADwKAAChFQAABgEAAGsMAADQFwAANQMAAJoOAAD/GQAAZAUAAMkQAAAuHAAAkwcAAPgSAABdHgAA
| wgkAACcVAACMAAAA8QsAAFYXAAC7AgAAIA4AAIUZAADqBAAATxAAALQbAAAZBwAAfhIAAOMdAABICQAArRQAABIAAAB3CwAA
| 3BYAAEECAACmDQAACxkAAHAEAADVDwAAOhsAAJ8GAAAEEgAAaR0AAM4IAAAzFAAAmB8AAP0KAABiFgAAxwEAACwNAACRGAAA
| 9gMAAFsPAADAGgAAJQYAAIoRAADvHAAAVAgAALkTAAAeHwAAgwoAAOgVAABNAQAAsgwAABcYAAB8AwAA4Q4AAEYaAACrBQAA
| EBEAAHUcAADaBwAAPxMAAKQeAAAJCgAAbhUAANMAAAA4DAAAnRcAAAIDAABnDgAAEQYAAHYRAADbHAAAQAgAAKUTAAAKHwAA
| bwoAANQVAAA5AQAAngwAAAMYAABoAwAAzQ4AADIaAACXBQAA/BAAAGEcAADGBwAAKxMAAJAeAAD1CQAAWhUAAL8AAAAkDAAA
| iRcAAO4CAABTDgAAuBkAAB0FAACCEAAA5xsAAEwHAACxEgAAFh4AAHsJAADgFAAARQAAAKoLAAAPFwAAdAIAANkNAAA+GQAA
| owQAAAgQAABtGwAA0gYAADcSAACcHQAAAQkAAGYUAADLHwAAMAsAAJUWAAD6AQAAXw0AAMQYAAApBAAAjg8AAPMaAABYBgAA
| vREAACIdAACHCAAA7BMAAFEfAAC2CgAAGxYAAIABAADlDAAAShgAAK8DAAAUDwAAeRoAAN4FAABDEQAAqBwAAA0IAAByEwAA
| 1x4AADwKAAChFQAABgEAAGsMAADQFwAANQMAAJoOAAD/GQAAZAUAAMkQAAAuHAAAkwcAAPgSAABdHgAAwgkAACcVAACMAAAA
| 8QsAAFYXAAC7AgAAIA4AAIUZAADqBAAATxAAALQbAAAZBwAAfhIAAOMdAABICQAArRQAABIAAAB3CwAA3BYAAEECAACmDQAA
| CxkAAHAEAADVDwAAOhsAAJ8GAAAEEgAAaR0AAM4IAAAzFAAAmB8AAP0KAABiFgAAxwEAACwNAACRGAAA9gMAAFsPAADAGgAA
| JQYAAIoRAADvHAAAVAgAALkTAAAeHwAAgwoAAOgVAABNAQAAsgwAABcYAAB8AwAA4Q4AAEYaAACrBQAAEBEAAHUcAADaBwAA
| PxMAAKQeAAAJCgAAbhUAANMAAAA4DAAAnRcAAAIDAABnDgAAzBkAADEFAACWEAAA+xsAAGAHAADFEgAAKh4AAI8JAAD0FAAA
| WQAAAL4LAAAjFwAAiAIAAO0NAABSGQAAtwQAABwQAACBGwAA5gYAAEsSAACwHQAAFQkAAHoUAADfHwAARAsAAKkWAAAOAgAA
| cw0AANgYAAA9BAAAog8AAAcbAABsBgAA0REAADYdAACbCAAAABQAAGUfAADKCgAALxYAAJQBAAD5DAAAXhgAAMMDAAAoDwAA
| jRoAAPIFAABXEQAAvBwAACEIAACGEwAA6x4AAFAKAAC1FQAAGgEAAH8MAADkFwAASQMAAK4OAAATGgAAeAUAAN0QAABCHAAA
| pwcAAAwTAABxHgAA1gkAADsVAACgAAAABQwAAGoXAADPAgAANA4AAJkZAAD+BAAAYxAAAMgbAAAtBwAAkhIAAPcdAABcCQAA
| wRQAACYAAACLCwAA8BYAAFUCAAC6DQAAHxkAAIQEAADpDwAAThsAALMGAAAYEgAAfR0AAOIIAABHFAAArB8AAFYXAAC7AgAA
| IA4AAIUZAADqBAAATxAAALQbAAAZBwAAfhIAAOMdAABICQAArRQAABIAAAB3CwAA3BYAAEECAACmDQAACxkAAHAEAADVDwAA
| OhsAAJ8GAAAEEgAAaR0AAM4IAAAzFAAAmB8AAP0KAABiFgAAxwEAACwNAACRGAAA9gMAAFsPAADAGgAAJQYAAIoRAADvHAAA
| VAgAALkTAAAeHwAAgwoAAOgVAABNAQAAsgwAABcYAAB8AwAA4Q4AAEYaAACrBQAAEBEAAHUcAADaBwAAPxMAAKQeAAAJCgAA
| bhUAANMAAAA4DAAAnRcAAAIDAABnDgAAzBkAADEFAACWEAAA+xsAAGAHAADFEgAAKh4AAI8JAAD0FAAAWQAAAL4LAAAjFwAA
| iAIAAO0NAABSGQAAtwQAABwQAACBGwAA5gYAAEsSAACwHQAAFQkAAHoUAADfHwAARAsAAKkWAAAOAgAAcw0AANgYAAA9BAAA
| og8AAAcbAABsBgAA0REAADYdAACbCAAAABQAAGUfAADKCgAALxYAAJQBAAD5DAAAXhgAAMMDAAAoDwAAjRoAAPIFAABXEQAA
| vBwAACEIAACGEwAA6x4AAFAKAAC1FQAAGgEAAH8MAADkFwAASQMAAK4OAAATGgAAeAUAAN0QAABCHAAApwcAAAwTAABxHgAA
| 1gkAADsVAACgAAAABQwAAGoXAADPAgAANA4AAJkZAAD+BAAAYxAAAMgbAAAtBwAAkhIAAPcdAABcCQAAwRQAACYAAACLCwAA
| 8BYAAFUCAAC6DQAAHxkAAIQEAADpDwAAThsAALMGAAAYEgAAfR0AAOIIAABHFAAArB8AABELAAB2FgAA2wEAAEANAAClGAAA
| CgQAAG8PAADUGgAAOQYAAJ4RAAADHQAAaAgAAM0TAAAyHwAAlwoAAPwVAABhAQAAxgwAACsYAACQAwAA9Q4AAFoaAAC/BQAA
| JBEAAIkcAADuBwAAUxMAALgeAAAdCgAAghUAAOcAAABMDAAAsRcAABYDAAB7DgAA4BkAAEUFAACqEAAADxwAAHQHAADZEgAA
| Ph4AAKMJAAAIFQAAbQAAANILAAA3FwAAnAIAAAEOAABmGQAAywQAADAQAACVGwAA+gYAAF8SAADEHQAAKQkAAI4UAADzHwAA
| WAsAAL0WAAAiAgAAhw0AAOwYAABRBAAAtg8AABsbAACABgAA5REAAEodAACvCAAAFBQAAHkfAADeCgAAQxYAAKgBAAANDQAA
| chgAANcDAAA8DwAAoRoAAAYGAABrEQAA0BwAADUIAACaEwAA/x4AAGQKAADJFQAALgEAAJMMAAD4FwAAXQMAAMIOAAAnGgAA
| jAUAAPEQAACbCAAAABQAAGUfAADKCgAALxYAAJQBAAD5DAAAXhgAAMMDAAAoDwAAjRoAAPIFAABXEQAAvBwAACEIAACGEwAA
| 6x4AAFAKAAC1FQAAGgEAAH8MAADkFwAASQMAAK4OAAATGgAAeAUAAN0QAABCHAAApwcAAAwTAABxHgAA1gkAADsVAACgAAAA
| BQwAAGoXAADPAgAANA4AAJkZAAD+BAAAYxAAAMgbAAAtBwAAkhIAAPcdAABcCQAAwRQAACYAAACLCwAA8BYAAFUCAAC6DQAA
| HxkAAIQEAADpDwAAThsAALMGAAAYEgAAfR0AAOIIAABHFAAArB8AABELAAB2FgAA2wEAAEANAAClGAAACgQAAG8PAADUGgAA
| OQYAAJ4RAAADHQAAaAgAAM0TAAAyHwAAlwoAAPwVAABhAQAAxgwAACsYAACQAwAA9Q4AAFoaAAC/BQAAJBEAAIkcAADuBwAA
| UxMAALgeAAAdCgAAghUAAOcAAABMDAAAsRcAABYDAAB7DgAA4BkAAEUFAACqEAAADxwAAHQHAADZEgAAPh4AAKMJAAAIFQAA
| bQAAANILAAA3FwAAnAIAAAEOAABmGQAAywQAADAQAACVGwAA+gYAAF8SAADEHQAAKQkAAI4UAADzHwAAWAsAAL0WAAAiAgAA
| hw0AAOwYAABRBAAAtg8AABsbAACABgAA5REAAEodAACvCAAAFBQAAHkfAADeCgAAQxYAAKgBAAANDQAAchgAANcDAAA8DwAA
| oRoAAAYGAABrEQAA0BwAADUIAACaEwAA/x4AAGQKAADJFQAALgEAAJMMAAD4FwAAXQMAAMIOAAAnGgAAjAUAAPEQAABWHAAA
| uwcAACATAACFHgAA6gkAAE8VAAC0AAAAGQwAAH4XAADjAgAASA4AAK0ZAAASBQAAdxAAANwbAABBBwAAphIAAAseAABwCQAA
| 1RQAADoAAACfCwAABBcAAGkCAADODQAAMxkAAJgEAAD9DwAAYhsAAMcGAAAsEgAAkR0AAPYIAABbFAAAwB8AACULAACKFgAA
| 7wEAAFQNAAC5GAAAHgQAAIMPAADoGgAATQYAALIRAAAXHQAAfAgAAOETAABGHwAAqwoAABAWAAB1AQAA2gwAAD8YAACkAwAA
| CQ8AAG4aAADTBQAAOBEAAJ0cAAACCAAAZxMAAMweAAAxCgAAlhUAAPsAAABgDAAAxRcAACoDAACPDgAA9BkAAFkFAAC+EAAA
| IxwAAIgHAADtEgAAUh4AALcJAAAcFQAAgQAAAOYLAABLFwAAsAIAABUOAAB6GQAA3wQAAEQQAACpGwAADgcAAHMSAADYHQAA
| PQkAAKIUAAAHAAAAbAsAANEWAAA2AgAA4BkAAEUFAACqEAAADxwAAHQHAADZEgAAPh4AAKMJAAAIFQAAbQAAANILAAA3FwAA
| nAIAAAEOAABmGQAAywQAADAQAACVGwAA+gYAAF8SAADEHQAAKQkAAI4UAADzHwAAWAsAAL0WAAAiAgAAhw0AAOwYAABRBAAA
| tg8AABsbAACABgAA5REAAEodAACvCAAAFBQAAHkfAADeCgAAQxYAAKgBAAANDQAAchgAANcDAAA8DwAAoRoAAAYGAABrEQAA
| 0BwAADUIAACaEwAA/x4AAGQKAADJFQAALgEAAJMMAAD4FwAAXQMAAMIOAAAnGgAAjAUAAPEQAABWHAAAuwcAACATAACFHgAA
| 6gkAAE8VAAC0AAAAGQwAAH4XAADjAgAASA4AAK0ZAAASBQAAdxAAANwbAABBBwAAphIAAAseAABwCQAA1RQAADoAAACfCwAA
| BBcAAGkCAADODQAAMxkAAJgEAAD9DwAAYhsAAMcGAAAsEgAAkR0AAPYIAABbFAAAwB8AACULAACKFgAA7wEAAFQNAAC5GAAA
| HgQAAIMPAADoGgAATQYAALIRAAAXHQAAfAgAAOETAABGHwAAqwoAABAWAAB1AQAA2gwAAD8YAACkAwAACQ8AAG4aAADTBQAA
| OBEAAJ0cAAACCAAAZxMAAMweAAAxCgAAlhUAAPsAAABgDAAAxRcAACoDAACPDgAA9BkAAFkFAAC+EAAAIxwAAIgHAADtEgAA
| Uh4AALcJAAAcFQAAgQAAAOYLAABLFwAAsAIAABUOAAB6GQAA3wQAAEQQAACpGwAADgcAAHMSAADYHQAAPQkAAKIUAAAHAAAA
| bAsAANEWAAA2AgAAmw0AAAAZAABlBAAAyg8AAC8bAACUBgAA+REAAF4dAADDCAAAKBQAAI0fAADyCgAAVxYAALwBAAAhDQAA
| hhgAAOsDAABQDwAAtRoAABoGAAB/EQAA5BwAAEkIAACuEwAAEx8AAHgKAADdFQAAQgEAAKcMAAAMGAAAcQMAANYOAAA7GgAA
| oAUAAAURAABqHAAAzwcAADQTAACZHgAA/gkAAGMVAADIAAAALQwAAJIXAAD3AgAAXA4AAMEZAAAmBQAAixAAAPAbAABVBwAA
| uhIAAB8eAACECQAA6RQAAE4AAACzCwAAGBcAAH0CAADiDQAARxkAAKwEAAAREAAAdhsAANsGAABAEgAApR0AAAoJAABvFAAA
| 1B8AADkLAACeFgAAAwIAAGgNAADNGAAAMgQAAJcPAAD8GgAAYQYAAMYRAAArHQAAkAgAAPUTAABaHwAAvwoAACQWAACJAQAA
| 7gwAAFMYAAC4AwAAHQ8AAIIaAADnBQAATBEAALEcAAAWCAAAexMAACULAACKFgAA7wEAAFQNAAC5GAAAHgQAAIMPAADoGgAA
| TQYAALIRAAAXHQAAfAgAAOETAABGHwAAqwoAABAWAAB1AQAA2gwAAD8YAACkAwAACQ8AAG4aAADTBQAAOBEAAJ0cAAACCAAA
| ZxMAAMweAAAxCgAAlhUAAPsAAABgDAAAxRcAACoDAACPDgAA9BkAAFkFAAC+EAAAIxwAAIgHAADtEgAAUh4AALcJAAAcFQAA
| gQAAAOYLAABLFwAAsAIAABUOAAB6GQAA3wQAAEQQAACpGwAADgcAAHMSAADYHQAAPQkAAKIUAAAHAAAAbAsAANEWAAA2AgAA
| mw0AAAAZAABlBAAAyg8AAC8bAACUBgAA+REAAF4dAADDCAAAKBQAAI0fAADyCgAAVxYAALwBAAAhDQAAhhgAAOsDAABQDwAA
| tRoAABoGAAB/EQAA5BwAAEkIAACuEwAAEx8AAHgKAADdFQAAQgEAAKcMAAAMGAAAcQMAANYOAAA7GgAAoAUAAAURAABqHAAA
| zwcAADQTAACZHgAA/gkAAGMVAADIAAAALQwAAJIXAAD3AgAAXA4AAMEZAAAmBQAAixAAAPAbAABVBwAAuhIAAB8eAACECQAA
| 6RQAAE4AAACzCwAAGBcAAH0CAADiDQAARxkAAKwEAAAREAAAdhsAANsGAABAEgAApR0AAAoJAABvFAAA1B8AADkLAACeFgAA
| AwIAAGgNAADNGAAAMgQAAJcPAAD8GgAAYQYAAMYRAAArHQAAkAgAAPUTAABaHwAAvwoAACQWAACJAQAA7gwAAFMYAAC4AwAA
| HQ8AAIIaAADnBQAATBEAALEcAAAWCAAAexMAAOAeAABFCgAAqhUAAA8BAAB0DAAA2RcAAD4DAACjDgAACBoAAG0FAADSEAAA
| NxwAAJwHAAABEwAAZh4AAMsJAAAwFQAAlQAAAPoLAABfFwAAxAIAACkOAACOGQAA8wQAAFgQAAC9GwAAIgcAAIcSAADsHQAA
| UQkAALYUAAAbAAAAgAsAAOUWAABKAgAArw0AABQZAAB5BAAA3g8AAEMbAACoBgAADRIAAHIdAADXCAAAPBQAAKEfAAAGCwAA
| axYAANABAAA1DQAAmhgAAP8DAABkDwAAyRoAAC4GAACTEQAA+BwAAF0IAADCEwAAJx8AAIwKAADxFQAAVgEAALsMAAAgGAAA
| hQMAAOoOAABPGgAAtAUAABkRAAB+HAAA4wcAAEgTAACtHgAAEgoAAHcVAADcAAAAQQwAAKYXAAALAwAAcA4AANUZAAA6BQAA
| nxAAAAQcAABpBwAAzhIAADMeAACYCQAA/RQAAGIAAADHCwAALBcAAJECAAD2DQAAWxkAAMAEAABqHAAAzwcAADQTAACZHgAA
| /gkAAGMVAADIAAAALQwAAJIXAAD3AgAAXA4AAMEZAAAmBQAAixAAAPAbAABVBwAAuhIAAB8eAACECQAA6RQAAE4AAACzCwAA
| GBcAAH0CAADiDQAARxkAAKwEAAAREAAAdhsAANsGAABAEgAApR0AAAoJAABvFAAA1B8AADkLAACeFgAAAwIAAGgNAADNGAAA
| MgQAAJcPAAD8GgAAYQYAAMYRAAArHQAAkAgAAPUTAABaHwAAvwoAACQWAACJAQAA7gwAAFMYAAC4AwAAHQ8AAIIaAADnBQAA
| TBEAALEcAAAWCAAAexMAAOAeAABFCgAAqhUAAA8BAAB0DAAA2RcAAD4DAACjDgAACBoAAG0FAADSEAAANxwAAJwHAAABEwAA
| Zh4AAMsJAAAwFQAAlQAAAPoLAABfFwAAxAIAACkOAACOGQAA8wQAAFgQAAC9GwAAIgcAAIcSAADsHQAAUQkAALYUAAAbAAAA
| gAsAAOUWAABKAgAArw0AABQZAAB5BAAA3g8AAEMbAACoBgAADRIAAHIdAADXCAAAPBQAAKEfAAAGCwAAaxYAANABAAA1DQAA
| mhgAAP8DAABkDwAAyRoAAC4GAACTEQAA+BwAAF0IAADCEwAAJx8AAIwKAADxFQAAVgEAALsMAAAgGAAAhQMAAOoOAABPGgAA
| tAUAABkRAAB+HAAA4wcAAEgTAACtHgAAEgoAAHcVAADcAAAAQQwAAKYXAAALAwAAcA4AANUZAAA6BQAAnxAAAAQcAABpBwAA
| zhIAADMeAACYCQAA/RQAAGIAAADHCwAALBcAAJECAAD2DQAAWxkAAMAEAAAlEAAAihsAAO8GAABUEgAAuR0AAB4JAACDFAAA
| 6B8AAE0LAACyFgAAFwIAAHwNAADhGAAARgQAAKsPAAAQGwAAdQYAANoRAAA/HQAApAgAAAkUAABuHwAA0woAADgWAACdAQAA
| Ag0AAGcYAADMAwAAMQ8AAJYaAAD7BQAAYBEAAMUcAAAqCAAAjxMAAPQeAABZCgAAvhUAACMBAACIDAAA7RcAAFIDAAC3DgAA
| HBoAAIEFAADmEAAASxwAALAHAAAVEwAAeh4AAN8JAABEFQAAqQAAAA4MAABzFwAA2AIAAD0OAACiGQAABwUAAGwQAADRGwAA
| NgcAAJsSAAAAHgAAZQkAAMoUAAAvAAAAlAsAAPkWAABeAgAAww0AACgZAACNBAAA8g8AAFcbAAC8BgAAIRIAAIYdAADrCAAA
| UBQAALUfAAAaCwAAfxYAAOQBAABJDQAArhgAABMEAAB4DwAA3RoAAEIGAACnEQAADB0AAHEIAADWEwAAOx8AAKAKAAAFFgAA
| rw0AABQZAAB5BAAA3g8AAEMbAACoBgAADRIAAHIdAADXCAAAPBQAAKEfAAAGCwAAaxYAANABAAA1DQAAmhgAAP8DAABkDwAA
| yRoAAC4GAACTEQAA+BwAAF0IAADCEwAAJx8AAIwKAADxFQAAVgEAALsMAAAgGAAAhQMAAOoOAABPGgAAtAUAABkRAAB+HAAA
| 4wcAAEgTAACtHgAAEgoAAHcVAADcAAAAQQwAAKYXAAALAwAAcA4AANUZAAA6BQAAnxAAAAQcAABpBwAAzhIAADMeAACYCQAA
| /RQAAGIAAADHCwAALBcAAJECAAD2DQAAWxkAAMAEAAAlEAAAihsAAO8GAABUEgAAuR0AAB4JAACDFAAA6B8AAE0LAACyFgAA
| FwIAAHwNAADhGAAARgQAAKsPAAAQGwAAdQYAANoRAAA/HQAApAgAAAkUAABuHwAA0woAADgWAACdAQAAAg0AAGcYAADMAwAA
| MQ8AAJYaAAD7BQAAYBEAAMUcAAAqCAAAjxMAAPQeAABZCgAAvhUAACMBAACIDAAA7RcAAFIDAAC3DgAAHBoAAIEFAADmEAAA
| SxwAALAHAAAVEwAAeh4AAN8JAABEFQAAqQAAAA4MAABzFwAA2AIAAD0OAACiGQAABwUAAGwQAADRGwAANgcAAJsSAAAAHgAA
| ZQkAAMoUAAAvAAAAlAsAAPkWAABeAgAAww0AACgZAACNBAAA8g8AAFcbAAC8BgAAIRIAAIYdAADrCAAAUBQAALUfAAAaCwAA
| fxYAAOQBAABJDQAArhgAABMEAAB4DwAA3RoAAEIGAACnEQAADB0AAHEIAADWEwAAOx8AAKAKAAAFFgAAagEAAM8MAAA0GAAA
| mQMAAP4OAABjGgAAyAUAAC0RAACSHAAA9wcAAFwTAADBHgAAJgoAAIsVAADwAAAAVQwAALoXAAAfAwAAhA4AAOkZAABOBQAA
| sxAAABgcAAB9BwAA4hIAAEceAACsCQAAERUAAHYAAADbCwAAQBcAAKUCAAAKDgAAbxkAANQEAAA5EAAAnhsAAAMHAABoEgAA
| zR0AADIJAACXFAAA/B8AAGELAADGFgAAKwIAAJANAAD1GAAAWgQAAL8PAAAkGwAAiQYAAO4RAABTHQAAuAgAAB0UAACCHwAA
| 5woAAEwWAACxAQAAFg0AAHsYAADgAwAARQ8AAKoaAAAPBgAAdBEAANkcAAA+CAAAoxMAAAgfAABtCgAA0hUAADcBAACcDAAA
| ARgAAGYDAADLDgAAMBoAAJUFAAD6EAAAXxwAAMQHAAApEwAAjh4AAPMJAABYFQAAvQAAACIMAACHFwAA7AIAAFEOAAC2GQAA
| GwUAAIAQAADlGwAASgcAAPQeAABZCgAAvhUAACMBAACIDAAA7RcAAFIDAAC3DgAAHBoAAIEFAADmEAAASxwAALAHAAAVEwAA
| eh4AAN8JAABEFQAAqQAAAA4MAABzFwAA2AIAAD0OAACiGQAABwUAAGwQAADRGwAANgcAAJsSAAAAHgAAZQkAAMoUAAAvAAAA
| lAsAAPkWAABeAgAAww0AACgZAACNBAAA8g8AAFcbAAC8BgAAIRIAAIYdAADrCAAAUBQAALUfAAAaCwAAfxYAAOQBAABJDQAA
| rhgAABMEAAB4DwAA3RoAAEIGAACnEQAADB0AAHEIAADWEwAAOx8AAKAKAAAFFgAAagEAAM8MAAA0GAAAmQMAAP4OAABjGgAA
| yAUAAC0RAACSHAAA9wcAAFwTAADBHgAAJgoAAIsVAADwAAAAVQwAALoXAAAfAwAAhA4AAOkZAABOBQAAsxAAABgcAAB9BwAA
| 4hIAAEceAACsCQAAERUAAHYAAADbCwAAQBcAAKUCAAAKDgAAbxkAANQEAAA5EAAAnhsAAAMHAABoEgAAzR0AADIJAACXFAAA
| /B8AAGELAADGFgAAKwIAAJANAAD1GAAAWgQAAL8PAAAkGwAAiQYAAO4RAABTHQAAuAgAAB0UAACCHwAA5woAAEwWAACxAQAA
| Fg0AAHsYAADgAwAARQ8AAKoaAAAPBgAAdBEAANkcAAA+CAAAoxMAAAgfAABtCgAA0hUAADcBAACcDAAAARgAAGYDAADLDgAA
| MBoAAJUFAAD6EAAAXxwAAMQHAAApEwAAjh4AAPMJAABYFQAAvQAAACIMAACHFwAA7AIAAFEOAAC2GQAAGwUAAIAQAADlGwAA
| SgcAAK8SAAAUHgAAeQkAAN4UAABDAAAAqAsAAA0XAAByAgAA1w0AADwZAAChBAAABhAAAGsbAADQBgAANRIAAJodAAD/CAAA
| ZBQAAMkfAAAuCwAAkxYAAPgBAABdDQAAwhgAACcEAACMDwAA8RoAAFYGAAC7EQAAIB0AAIUIAADqEwAATx8AALQKAAAZFgAA
| fgEAAOMMAABIGAAArQMAABIPAAB3GgAA3AUAAEERAACmHAAACwgAAHATAADVHgAAOgoAAJ8VAAAEAQAAaQwAAM4XAAAzAwAA
| mA4AAP0ZAABiBQAAxxAAACwcAACRBwAA9hIAAFseAADACQAAJRUAAIoAAADvCwAAVBcAALkCAAAeDgAAgxkAAOgEAABNEAAA
| shsAABcHAAB8EgAA4R0AAEYJAACrFAAAEAAAAHULAADaFgAAPwIAAKQNAAAJGQAAbgQAANMPAAA4GwAAnQYAAAISAABnHQAA
| zAgAADEUAACWHwAA+woAAGAWAADFAQAAKg0AAI8YAAA5EAAAnhsAAAMHAABoEgAAzR0AADIJAACXFAAA/B8AAGELAADGFgAA
| KwIAAJANAAD1GAAAWgQAAL8PAAAkGwAAiQYAAO4RAABTHQAAuAgAAB0UAACCHwAA5woAAEwWAACxAQAAFg0AAHsYAADgAwAA
| RQ8AAKoaAAAPBgAAdBEAANkcAAA+CAAAoxMAAAgfAABtCgAA0hUAADcBAACcDAAAARgAAGYDAADLDgAAMBoAAJUFAAD6EAAA
| XxwAAMQHAAApEwAAjh4AAPMJAABYFQAAvQAAACIMAACHFwAA7AIAAFEOAAC2GQAAGwUAAIAQAADlGwAASgcAAK8SAAAUHgAA
| eQkAAN4UAABDAAAAqAsAAA0XAAByAgAA1w0AADwZAAChBAAABhAAAGsbAADQBgAANRIAAJodAAD/CAAAZBQAAMkfAAAuCwAA
| kxYAAPgBAABdDQAAwhgAACcEAACMDwAA8RoAAFYGAAC7EQAAIB0AAIUIAADqEwAATx8AALQKAAAZFgAAfgEAAOMMAABIGAAA
| rQMAABIPAAB3GgAA3AUAAEERAACmHAAACwgAAHATAADVHgAAOgoAAJ8VAAAEAQAAaQwAAM4XAAAzAwAAmA4AAP0ZAABiBQAA
| xxAAACwcAACRBwAA9hIAAFseAADACQAAJRUAAIoAAADvCwAAVBcAALkCAAAeDgAAgxkAAOgEAABNEAAAshsAABcHAAB8EgAA
| 4R0AAEYJAACrFAAAEAAAAHULAADaFgAAPwIAAKQNAAAJGQAAbgQAANMPAAA4GwAAnQYAAAISAABnHQAAzAgAADEUAACWHwAA
| +woAAGAWAADFAQAAKg0AAI8YAAD0AwAAWQ8AAL4aAAAjBgAAiBEAAO0cAABSCAAAtxMAABwfAACBCgAA5hUAAEsBAACwDAAA
| FRgAAHoDAADfDgAARBoAAKkFAAAOEQAAcxwAANgHAAA9EwAAoh4AAAcKAABsFQAA0QAAADYMAACbFwAAAAMAAGUOAADKGQAA
| LwUAAJQQAAD5GwAAXgcAAMMSAAAoHgAAjQkAAPIUAABXAAAAvAsAACEXAACGAgAA6w0AAFAZAAC1BAAAGhAAAH8bAADkBgAA
| SRIAAK4dAAATCQAAeBQAAN0fAABCCwAApxYAAAwCAABxDQAA1hgAADsEAACgDwAABRsAAGoGAADPEQAANB0AAJkIAAD+EwAA
| Yx8AAMgKAAAtFgAAkgEAAPcMAABcGAAAwQMAACYPAACLGgAA8AUAAFURAAC6HAAAHwgAAIQTAADpHgAATgoAALMVAAAYAQAA
| fQwAAOIXAABHAwAArA4AABEaAAB2BQAA2xAAAEAcAAClBwAAChMAAG8eAADUCQAAfgEAAOMMAABIGAAArQMAABIPAAB3GgAA
| 3AUAAEERAACmHAAACwgAAHATAADVHgAAOgoAAJ8VAAAEAQAAaQwAAM4XAAAzAwAAmA4AAP0ZAABiBQAAxxAAACwcAACRBwAA
| 9hIAAFseAADACQAAJRUAAIoAAADvCwAAVBcAALkCAAAeDgAAgxkAAOgEAABNEAAAshsAABcHAAB8EgAA4R0AAEYJAACrFAAA
| EAAAAHULAADaFgAAPwIAAKQNAAAJGQAAbgQAANMPAAA4GwAAnQYAAAISAABnHQAAzAgAADEUAACWHwAA+woAAGAWAADFAQAA
| Kg0AAI8YAAD0AwAAWQ8AAL4aAAAjBgAAiBEAAO0cAABSCAAAtxMAABwfAACBCgAA5hUAAEsBAACwDAAAFRgAAHoDAADfDgAA
| RBoAAKkFAAAOEQAAcxwAANgHAAA9EwAAoh4AAAcKAABsFQAA0QAAADYMAACbFwAAAAMAAGUOAADKGQAALwUAAJQQAAD5GwAA
| XgcAAMMSAAAoHgAAjQkAAPIUAABXAAAAvAsAACEXAACGAgAA6w0AAFAZAAC1BAAAGhAAAH8bAADkBgAASRIAAK4dAAATCQAA
| eBQAAN0fAABCCwAApxYAAAwCAABxDQAA1hgAADsEAACgDwAABRsAAGoGAADPEQAANB0AAJkIAAD+EwAAYx8AAMgKAAAtFgAA
| kgEAAPcMAABcGAAAwQMAACYPAACLGgAA8AUAAFURAAC6HAAAHwgAAIQTAADpHgAATgoAALMVAAAYAQAAfQwAAOIXAABHAwAA
| rA4AABEaAAB2BQAA2xAAAEAcAAClBwAAChMAAG8eAADUCQAAORUAAJ4AAAADDAAAaBcAAM0CAAAyDgAAlxkAAPwEAABhEAAA
| xhsAACsHAACQEgAA9R0AAFoJAAC/FAAAJAAAAIkLAADuFgAAUwIAALgNAAAdGQAAggQAAOcPAABMGwAAsQYAABYSAAB7HQAA
| 4AgAAEUUAACqHwAADwsAAHQWAADZAQAAPg0AAKMYAAAIBAAAbQ8AANIaAAA3BgAAnBEAAAEdAABmCAAAyxMAADAfAACVCgAA
| +hUAAF8BAADEDAAAKRgAAI4DAADzDgAAWBoAAL0FAAAiEQAAhxwAAOwHAABREwAAth4AABsKAACAFQAA5QAAAEoMAACvFwAA
| FAMAAHkOAADeGQAAQwUAAKgQAAANHAAAcgcAANcSAAA8HgAAoQkAAAYVAABrAAAA0AsAADUXAACaAgAA/w0AAGQZAADJBAAA
| LhAAAJMbAAD4BgAAXRIAAMIdAAAnCQAAjBQAAPEfAABWCwAAuxYAACACAACFDQAA6hgAAE8EAAC0DwAAGRsAAMMSAAAoHgAA
| jQkAAPIUAABXAAAAvAsAACEXAACGAgAA6w0AAFAZAAC1BAAAGhAAAH8bAADkBgAASRIAAK4dAAATCQAAeBQAAN0fAABCCwAA
| pxYAAAwCAABxDQAA1hgAADsEAACgDwAABRsAAGoGAADPEQAANB0AAJkIAAD+EwAAYx8AAMgKAAAtFgAAkgEAAPcMAABcGAAA
| wQMAACYPAACLGgAA8AUAAFURAAC6HAAAHwgAAIQTAADpHgAATgoAALMVAAAYAQAAfQwAAOIXAABHAwAArA4AABEaAAB2BQAA
| 2xAAAEAcAAClBwAAChMAAG8eAADUCQAAORUAAJ4AAAADDAAAaBcAAM0CAAAyDgAAlxkAAPwEAABhEAAAxhsAACsHAACQEgAA
| 9R0AAFoJAAC/FAAAJAAAAIkLAADuFgAAUwIAALgNAAAdGQAAggQAAOcPAABMGwAAsQYAABYSAAB7HQAA4AgAAEUUAACqHwAA
| DwsAAHQWAADZAQAAPg0AAKMYAAAIBAAAbQ8AANIaAAA3BgAAnBEAAAEdAABmCAAAyxMAADAfAACVCgAA+hUAAF8BAADEDAAA
| KRgAAI4DAADzDgAAWBoAAL0FAAAiEQAAhxwAAOwHAABREwAAth4AABsKAACAFQAA5QAAAEoMAACvFwAAFAMAAHkOAADeGQAA
| QwUAAKgQAAANHAAAcgcAANcSAAA8HgAAoQkAAAYVAABrAAAA0AsAADUXAACaAgAA/w0AAGQZAADJBAAALhAAAJMbAAD4BgAA
| XRIAAMIdAAAnCQAAjBQAAPEfAABWCwAAuxYAACACAACFDQAA6hgAAE8EAAC0DwAAGRsAAH4GAADjEQAASB0AAK0IAAASFAAA
| dx8AANwKAABBFgAApgEAAAsNAABwGAAA1QMAADoPAACfGgAABAYAAGkRAADOHAAAMwgAAJgTAAD9HgAAYgoAAMcVAAAsAQAA
| kQwAAPYXAABbAwAAwA4AACUaAACKBQAA7xAAAFQcAAC5BwAAHhMAAIMeAADoCQAATRUAALIAAAAXDAAAfBcAAOECAABGDgAA
| qxkAABAFAAB1EAAA2hsAAD8HAACkEgAACR4AAG4JAADTFAAAOAAAAJ0LAAACFwAAZwIAAMwNAAAxGQAAlgQAAPsPAABgGwAA
| xQYAACoSAACPHQAA9AgAAFkUAAC+HwAAIwsAAIgWAADtAQAAUg0AALcYAAAcBAAAgQ8AAOYaAABLBgAAsBEAABUdAAB6CAAA
| 3xMAAEQfAACpCgAADhYAAHMBAADYDAAAPRgAAKIDAAAHDwAAbBoAANEFAAA2EQAAmxwAAAAIAABlEwAAyh4AAC8KAACUFQAA
| +QAAAF4MAAAIBAAAbQ8AANIaAAA3BgAAnBEAAAEdAABmCAAAyxMAADAfAACVCgAA+hUAAF8BAADEDAAAKRgAAI4DAADzDgAA
| WBoAAL0FAAAiEQAAhxwAAOwHAABREwAAth4AABsKAACAFQAA5QAAAEoMAACvFwAAFAMAAHkOAADeGQAAQwUAAKgQAAANHAAA
| cgcAANcSAAA8HgAAoQkAAAYVAABrAAAA0AsAADUXAACaAgAA/w0AAGQZAADJBAAALhAAAJMbAAD4BgAAXRIAAMIdAAAnCQAA
| jBQAAPEfAABWCwAAuxYAACACAACFDQAA6hgAAE8EAAC0DwAAGRsAAH4GAADjEQAASB0AAK0IAAASFAAAdx8AANwKAABBFgAA
| pgEAAAsNAABwGAAA1QMAADoPAACfGgAABAYAAGkRAADOHAAAMwgAAJgTAAD9HgAAYgoAAMcVAAAsAQAAkQwAAPYXAABbAwAA
| wA4AACUaAACKBQAA7xAAAFQcAAC5BwAAHhMAAIMeAADoCQAATRUAALIAAAAXDAAAfBcAAOECAABGDgAAqxkAABAFAAB1EAAA
| 2hsAAD8HAACkEgAACR4AAG4JAADTFAAAOAAAAJ0LAAACFwAAZwIAAMwNAAAxGQAAlgQAAPsPAABgGwAAxQYAACoSAACPHQAA
| 9AgAAFkUAAC+HwAAIwsAAIgWAADtAQAAUg0AALcYAAAcBAAAgQ8AAOYaAABLBgAAsBEAABUdAAB6CAAA3xMAAEQfAACpCgAA
| DhYAAHMBAADYDAAAPRgAAKIDAAAHDwAAbBoAANEFAAA2EQAAmxwAAAAIAABlEwAAyh4AAC8KAACUFQAA+QAAAF4MAADDFwAA
| KAMAAI0OAADyGQAAVwUAALwQAAAhHAAAhgcAAOsSAABQHgAAtQkAABoVAAB/AAAA5AsAAEkXAACuAgAAEw4AAHgZAADdBAAA
| QhAAAKcbAAAMBwAAcRIAANYdAAA7CQAAoBQAAAUAAABqCwAAzxYAADQCAACZDQAA/hgAAGMEAADIDwAALRsAAJIGAAD3EQAA
| XB0AAMEIAAAmFAAAix8AAPAKAABVFgAAugEAAB8NAACEGAAA6QMAAE4PAACzGgAAGAYAAH0RAADiHAAARwgAAKwTAAARHwAA
| dgoAANsVAABAAQAApQwAAAoYAABvAwAA1A4AADkaAACeBQAAAxEAAGgcAADNBwAAMhMAAJceAAD8CQAAYRUAAMYAAAArDAAA
| kBcAAPUCAABaDgAAvxkAACQFAACJEAAA7hsAAFMHAAC4EgAAHR4AAIIJAADnFAAATAAAALELAAAWFwAAewIAAOANAABFGQAA
| qgQAAA8QAAB0GwAA2QYAAD4SAACjHQAATRUAALIAAAAXDAAAfBcAAOECAABGDgAAqxkAABAFAAB1EAAA2hsAAD8HAACkEgAA
| CR4AAG4JAADTFAAAOAAAAJ0LAAACFwAAZwIAAMwNAAAxGQAAlgQAAPsPAABgGwAAxQYAACoSAACPHQAA9AgAAFkUAAC+HwAA
| IwsAAIgWAADtAQAAUg0AALcYAAAcBAAAgQ8AAOYaAABLBgAAsBEAABUdAAB6CAAA3xMAAEQfAACpCgAADhYAAHMBAADYDAAA
| PRgAAKIDAAAHDwAAbBoAANEFAAA2EQAAmxwAAAAIAABlEwAAyh4AAC8KAACUFQAA+QAAAF4MAADDFwAAKAMAAI0OAADyGQAA
| VwUAALwQAAAhHAAAhgcAAOsSAABQHgAAtQkAABoVAAB/AAAA5AsAAEkXAACuAgAAEw4AAHgZAADdBAAAQhAAAKcbAAAMBwAA
| cRIAANYdAAA7CQAAoBQAAAUAAABqCwAAzxYAADQCAACZDQAA/hgAAGMEAADIDwAALRsAAJIGAAD3EQAAXB0AAMEIAAAmFAAA
| ix8AAPAKAABVFgAAugEAAB8NAACEGAAA6QMAAE4PAACzGgAAGAYAAH0RAADiHAAARwgAAKwTAAARHwAAdgoAANsVAABAAQAA
| pQwAAAoYAABvAwAA1A4AADkaAACeBQAAAxEAAGgcAADNBwAAMhMAAJceAAD8CQAAYRUAAMYAAAArDAAAkBcAAPUCAABaDgAA
| vxkAACQFAACJEAAA7hsAAFMHAAC4EgAAHR4AAIIJAADnFAAATAAAALELAAAWFwAAewIAAOANAABFGQAAqgQAAA8QAAB0GwAA
| 2QYAAD4SAACjHQAACAkAAG0UAADSHwAANwsAAJwWAAABAgAAZg0AAMsYAAAwBAAAlQ8AAPoaAABfBgAAxBEAACkdAACOCAAA
| 8xMAAFgfAAC9CgAAIhYAAIcBAADsDAAAURgAALYDAAAbDwAAgBoAAOUFAABKEQAArxwAABQIAAB5EwAA3h4AAEMKAACoFQAA
| DQEAAHIMAADXFwAAPAMAAKEOAAAGGgAAawUAANAQAAA1HAAAmgcAAP8SAABkHgAAyQkAAC4VAACTAAAA+AsAAF0XAADCAgAA
| Jw4AAIwZAADxBAAAVhAAALsbAAAgBwAAhRIAAOodAABPCQAAtBQAABkAAAB+CwAA4xYAAEgCAACtDQAAEhkAAHcEAADcDwAA
| QRsAAKYGAAALEgAAcB0AANUIAAA6FAAAnx8AAAQLAABpFgAAzgEAADMNAACYGAAA/QMAAGIPAADHGgAALAYAAJERAAD2HAAA
| WwgAAMATAAAlHwAAigoAAO8VAABUAQAAuQwAAB4YAACDAwAA6A4AAJIGAAD3EQAAXB0AAMEIAAAmFAAAix8AAPAKAABVFgAA
| ugEAAB8NAACEGAAA6QMAAE4PAACzGgAAGAYAAH0RAADiHAAARwgAAKwTAAARHwAAdgoAANsVAABAAQAApQwAAAoYAABvAwAA
| 1A4AADkaAACeBQAAAxEAAGgcAADNBwAAMhMAAJceAAD8CQAAYRUAAMYAAAArDAAAkBcAAPUCAABaDgAAvxkAACQFAACJEAAA
| 7hsAAFMHAAC4EgAAHR4AAIIJAADnFAAATAAAALELAAAWFwAAewIAAOANAABFGQAAqgQAAA8QAAB0GwAA2QYAAD4SAACjHQAA
| CAkAAG0UAADSHwAANwsAAJwWAAABAgAAZg0AAMsYAAAwBAAAlQ8AAPoaAABfBgAAxBEAACkdAACOCAAA8xMAAFgfAAC9CgAA
| IhYAAIcBAADsDAAAURgAALYDAAAbDwAAgBoAAOUFAABKEQAArxwAABQIAAB5EwAA3h4AAEMKAACoFQAADQEAAHIMAADXFwAA
| PAMAAKEOAAAGGgAAawUAANAQAAA1HAAAmgcAAP8SAABkHgAAyQkAAC4VAACTAAAA+AsAAF0XAADCAgAAJw4AAIwZAADxBAAA
| VhAAALsbAAAgBwAAhRIAAOodAABPCQAAtBQAABkAAAB+CwAA4xYAAEgCAACtDQAAEhkAAHcEAADcDwAAQRsAAKYGAAALEgAA
| cB0AANUIAAA6FAAAnx8AAAQLAABpFgAAzgEAADMNAACYGAAA/QMAAGIPAADHGgAALAYAAJERAAD2HAAAWwgAAMATAAAlHwAA
| igoAAO8VAABUAQAAuQwAAB4YAACDAwAA6A4AAE0aAACyBQAAFxEAAHwcAADhBwAARhMAAKseAAAQCgAAdRUAANoAAAA/DAAA
| pBcAAAkDAABuDgAA0xkAADgFAACdEAAAAhwAAGcHAADMEgAAMR4AAJYJAAD7FAAAYAAAAMULAAAqFwAAjwIAAPQNAABZGQAA
| vgQAACMQAACIGwAA7QYAAFISAAC3HQAAHAkAAIEUAADmHwAASwsAALAWAAAVAgAAeg0AAN8YAABEBAAAqQ8AAA4bAABzBgAA
| 2BEAAD0dAACiCAAABxQAAGwfAADRCgAANhYAAJsBAAAADQAAZRgAAMoDAAAvDwAAlBoAAPkFAABeEQAAwxwAACgIAACNEwAA
| 8h4AAFcKAAC8FQAAIQEAAIYMAADrFwAAUAMAALUOAAAaGgAAfwUAAOQQAABJHAAArgcAABMTAAB4HgAA3QkAAEIVAACnAAAA
| DAwAAHEXAADWAgAAOw4AAKAZAAAFBQAAahAAAM8bAAA0BwAAmRIAAP4dAABjCQAAyBQAAC0AAADXFwAAPAMAAKEOAAAGGgAA
| awUAANAQAAA1HAAAmgcAAP8SAABkHgAAyQkAAC4VAACTAAAA+AsAAF0XAADCAgAAJw4AAIwZAADxBAAAVhAAALsbAAAgBwAA
| hRIAAOodAABPCQAAtBQAABkAAAB+CwAA4xYAAEgCAACtDQAAEhkAAHcEAADcDwAAQRsAAKYGAAALEgAAcB0AANUIAAA6FAAA
| nx8AAAQLAABpFgAAzgEAADMNAACYGAAA/QMAAGIPAADHGgAALAYAAJERAAD2HAAAWwgAAMATAAAlHwAAigoAAO8VAABUAQAA
| uQwAAB4YAACDAwAA6A4AAE0aAACyBQAAFxEAAHwcAADhBwAARhMAAKseAAAQCgAAdRUAANoAAAA/DAAApBcAAAkDAABuDgAA
| 0xkAADgFAACdEAAAAhwAAGcHAADMEgAAMR4AAJYJAAD7FAAAYAAAAMULAAAqFwAAjwIAAPQNAABZGQAAvgQAACMQAACIGwAA
| 7QYAAFISAAC3HQAAHAkAAIEUAADmHwAASwsAALAWAAAVAgAAeg0AAN8YAABEBAAAqQ8AAA4bAABzBgAA2BEAAD0dAACiCAAA
| BxQAAGwfAADRCgAANhYAAJsBAAAADQAAZRgAAMoDAAAvDwAAlBoAAPkFAABeEQAAwxwAACgIAACNEwAA8h4AAFcKAAC8FQAA
| IQEAAIYMAADrFwAAUAMAALUOAAAaGgAAfwUAAOQQAABJHAAArgcAABMTAAB4HgAA3QkAAEIVAACnAAAADAwAAHEXAADWAgAA
| Ow4AAKAZAAAFBQAAahAAAM8bAAA0BwAAmRIAAP4dAABjCQAAyBQAAC0AAACSCwAA9xYAAFwCAADBDQAAJhkAAIsEAADwDwAA
| VRsAALoGAAAfEgAAhB0AAOkIAABOFAAAsx8AABgLAAB9FgAA4gEAAEcNAACsGAAAEQQAAHYPAADbGgAAQAYAAKURAAAKHQAA
| bwgAANQTAAA5HwAAngoAAAMWAABoAQAAzQwAADIYAACXAwAA/A4AAGEaAADGBQAAKxEAAJAcAAD1BwAAWhMAAL8eAAAkCgAA
| iRUAAO4AAABTDAAAuBcAAB0DAACCDgAA5xkAAEwFAACxEAAAFhwAAHsHAADgEgAARR4AAKoJAAAPFQAAdAAAANkLAAA+FwAA
| owIAAAgOAABtGQAA0gQAADcQAACcGwAAAQcAAGYSAADLHQAAMAkAAJUUAAD6HwAAXwsAAMQWAAApAgAAjg0AAPMYAABYBAAA
| vQ8AACIbAACHBgAA7BEAAFEdAAC2CAAAGxQAAIAfAADlCgAAShYAAK8BAAAUDQAAeRgAAN4DAABDDwAAqBoAAA0GAAByEQAA
| HAkAAIEUAADmHwAASwsAALAWAAAVAgAAeg0AAN8YAABEBAAAqQ8AAA4bAABzBgAA2BEAAD0dAACiCAAABxQAAGwfAADRCgAA
| NhYAAJsBAAAADQAAZRgAAMoDAAAvDwAAlBoAAPkFAABeEQAAwxwAACgIAACNEwAA8h4AAFcKAAC8FQAAIQEAAIYMAADrFwAA
| UAMAALUOAAAaGgAAfwUAAOQQAABJHAAArgcAABMTAAB4HgAA3QkAAEIVAACnAAAADAwAAHEXAADWAgAAOw4AAKAZAAAFBQAA
| ahAAAM8bAAA0BwAAmRIAAP4dAABjCQAAyBQAAC0AAACSCwAA9xYAAFwCAADBDQAAJhkAAIsEAADwDwAAVRsAALoGAAAfEgAA
| hB0AAOkIAABOFAAAsx8AABgLAAB9FgAA4gEAAEcNAACsGAAAEQQAAHYPAADbGgAAQAYAAKURAAAKHQAAbwgAANQTAAA5HwAA
| ngoAAAMWAABoAQAAzQwAADIYAACXAwAA/A4AAGEaAADGBQAAKxEAAJAcAAD1BwAAWhMAAL8eAAAkCgAAiRUAAO4AAABTDAAA
| uBcAAB0DAACCDgAA5xkAAEwFAACxEAAAFhwAAHsHAADgEgAARR4AAKoJAAAPFQAAdAAAANkLAAA+FwAAowIAAAgOAABtGQAA
| 0gQAADcQAACcGwAAAQcAAGYSAADLHQAAMAkAAJUUAAD6HwAAXwsAAMQWAAApAgAAjg0AAPMYAABYBAAAvQ8AACIbAACHBgAA
| 7BEAAFEdAAC2CAAAGxQAAIAfAADlCgAAShYAAK8BAAAUDQAAeRgAAN4DAABDDwAAqBoAAA0GAAByEQAA1xwAADwIAAChEwAA
| Bh8AAGsKAADQFQAANQEAAJoMAAD/FwAAZAMAAMkOAAAuGgAAkwUAAPgQAABdHAAAwgcAACcTAACMHgAA8QkAAFYVAAC7AAAA
| IAwAAIUXAADqAgAATw4AALQZAAAZBQAAfhAAAOMbAABIBwAArRIAABIeAAB3CQAA3BQAAEEAAACmCwAACxcAAHACAADVDQAA
| OhkAAJ8EAAAEEAAAaRsAAM4GAAAzEgAAmB0AAP0IAABiFAAAxx8AACwLAACRFgAA9gEAAFsNAADAGAAAJQQAAIoPAADvGgAA
| VAYAALkRAAAeHQAAgwgAAOgTAABNHwAAsgoAABcWAAB8AQAA4QwAAEYYAACrAwAAEA8AAHUaAADaBQAAPxEAAKQcAAAJCAAA
| bhMAANMeAAA4CgAAnRUAAAIBAABnDAAAzBcAADEDAACWDgAA+xkAAGAFAADFEAAAKhwAAI8HAAD0EgAAWR4AAL4JAAAjFQAA
| iAAAAO0LAABSFwAAtwIAAGEaAADGBQAAKxEAAJAcAAD1BwAAWhMAAL8eAAAkCgAAiRUAAO4AAABTDAAAuBcAAB0DAACCDgAA
| 5xkAAEwFAACxEAAAFhwAAHsHAADgEgAARR4AAKoJAAAPFQAAdAAAANkLAAA+FwAAowIAAAgOAABtGQAA0gQAADcQAACcGwAA
| AQcAAGYSAADLHQAAMAkAAJUUAAD6HwAAXwsAAMQWAAApAgAAjg0AAPMYAABYBAAAvQ8AACIbAACHBgAA7BEAAFEdAAC2CAAA
| GxQAAIAfAADlCgAAShYAAK8BAAAUDQAAeRgAAN4DAABDDwAAqBoAAA0GAAByEQAA1xwAADwIAAChEwAABh8AAGsKAADQFQAA
| NQEAAJoMAAD/FwAAZAMAAMkOAAAuGgAAkwUAAPgQAABdHAAAwgcAACcTAACMHgAA8QkAAFYVAAC7AAAAIAwAAIUXAADqAgAA
| Tw4AALQZAAAZBQAAfhAAAOMbAABIBwAArRIAABIeAAB3CQAA3BQAAEEAAACmCwAACxcAAHACAADVDQAAOhkAAJ8EAAAEEAAA
| aRsAAM4GAAAzEgAAmB0AAP0IAABiFAAAxx8AACwLAACRFgAA9gEAAFsNAADAGAAAJQQAAIoPAADvGgAAVAYAALkRAAAeHQAA
| gwgAAOgTAABNHwAAsgoAABcWAAB8AQAA4QwAAEYYAACrAwAAEA8AAHUaAADaBQAAPxEAAKQcAAAJCAAAbhMAANMeAAA4CgAA
| nRUAAAIBAABnDAAAzBcAADEDAACWDgAA+xkAAGAFAADFEAAAKhwAAI8HAAD0EgAAWR4AAL4JAAAjFQAAiAAAAO0LAABSFwAA
| twIAABwOAACBGQAA5gQAAEsQAACwGwAAFQcAAHoSAADfHQAARAkAAKkUAAAOAAAAcwsAANgWAAA9AgAAog0AAAcZAABsBAAA
| 0Q8AADYbAACbBgAAABIAAGUdAADKCAAALxQAAJQfAAD5CgAAXhYAAMMBAAAoDQAAjRgAAPIDAABXDwAAvBoAACEGAACGEQAA
| 6xwAAFAIAAC1EwAAGh8AAH8KAADkFQAASQEAAK4MAAATGAAAeAMAAN0OAABCGgAApwUAAAwRAABxHAAA1gcAADsTAACgHgAA
| BQoAAGoVAADPAAAANAwAAJkXAAD+AgAAYw4AAMgZAAAtBQAAkhAAAPcbAABcBwAAwRIAACYeAACLCQAA8BQAAFUAAAC6CwAA
| HxcAAIQCAADpDQAAThkAALMEAAAYEAAAfRsAAOIGAABHEgAArB0AABEJAAB2FAAA2x8AAEALAAClFgAACgIAAG8NAADUGAAA
| OQQAAJ4PAAADGwAAaAYAAM0RAAAyHQAAlwgAAPwTAACmCwAACxcAAHACAADVDQAAOhkAAJ8EAAAEEAAAaRsAAM4GAAAzEgAA
| mB0AAP0IAABiFAAAxx8AACwLAACRFgAA9gEAAFsNAADAGAAAJQQAAIoPAADvGgAAVAYAALkRAAAeHQAAgwgAAOgTAABNHwAA
| sgoAABcWAAB8AQAA4QwAAEYYAACrAwAAEA8AAHUaAADaBQAAPxEAAKQcAAAJCAAAbhMAANMeAAA4CgAAnRUAAAIBAABnDAAA
| zBcAADEDAACWDgAA+xkAAGAFAADFEAAAKhwAAI8HAAD0EgAAWR4AAL4JAAAjFQAAiAAAAO0LAABSFwAAtwIAABwOAACBGQAA
| 5gQAAEsQAACwGwAAFQcAAHoSAADfHQAARAkAAKkUAAAOAAAAcwsAANgWAAA9AgAAog0AAAcZAABsBAAA0Q8AADYbAACbBgAA
| ABIAAGUdAADKCAAALxQAAJQfAAD5CgAAXhYAAMMBAAAoDQAAjRgAAPIDAABXDwAAvBoAACEGAACGEQAA6xwAAFAIAAC1EwAA
| Gh8AAH8KAADkFQAASQEAAK4MAAATGAAAeAMAAN0OAABCGgAApwUAAAwRAABxHAAA1gcAADsTAACgHgAABQoAAGoVAADPAAAA
| NAwAAJkXAAD+AgAAYw4AAMgZAAAtBQAAkhAAAPcbAABcBwAAwRIAACYeAACLCQAA8BQAAFUAAAC6CwAAHxcAAIQCAADpDQAA
| ThkAALMEAAAYEAAAfRsAAOIGAABHEgAArB0AABEJAAB2FAAA2x8AAEALAAClFgAACgIAAG8NAADUGAAAOQQAAJ4PAAADGwAA
| aAYAAM0RAAAyHQAAlwgAAPwTAABhHwAAxgoAACsWAACQAQAA9QwAAFoYAAC/AwAAJA8AAIkaAADuBQAAUxEAALgcAAAdCAAA
| ghMAAOceAABMCgAAsRUAABYBAAB7DAAA4BcAAEUDAACqDgAADxoAAHQFAADZEAAAPhwAAKMHAAAIEwAAbR4AANIJAAA3FQAA
| nAAAAAEMAABmFwAAywIAADAOAACVGQAA+gQAAF8QAADEGwAAKQcAAI4SAADzHQAAWAkAAL0UAAAiAAAAhwsAAOwWAABRAgAA
| tg0AABsZAACABAAA5Q8AAEobAACvBgAAFBIAAHkdAADeCAAAQxQAAKgfAAANCwAAchYAANcBAAA8DQAAoRgAAAYEAABrDwAA
| 0BoAADUGAACaEQAA/xwAAGQIAADJEwAALh8AAJMKAAD4FQAAXQEAAMIMAAAnGAAAjAMAAPEOAABWGgAAuwUAACARAACFHAAA
| 6gcAAE8TAAC0HgAAGQoAAH4VAADjAAAASAwAAK0XAAASAwAAdw4AANwZAABBBQAA6xwAAFAIAAC1EwAAGh8AAH8KAADkFQAA
| SQEAAK4MAAATGAAAeAMAAN0OAABCGgAApwUAAAwRAABxHAAA1gcAADsTAACgHgAABQoAAGoVAADPAAAANAwAAJkXAAD+AgAA
| Yw4AAMgZAAAtBQAAkhAAAPcbAABcBwAAwRIAACYeAACLCQAA8BQAAFUAAAC6CwAAHxcAAIQCAADpDQAAThkAALMEAAAYEAAA
| fRsAAOIGAABHEgAArB0AABEJAAB2FAAA2x8AAEALAAClFgAACgIAAG8NAADUGAAAOQQAAJ4PAAADGwAAaAYAAM0RAAAyHQAA
| lwgAAPwTAABhHwAAxgoAACsWAACQAQAA9QwAAFoYAAC/AwAAJA8AAIkaAADuBQAAUxEAALgcAAAdCAAAghMAAOceAABMCgAA
| sRUAABYBAAB7DAAA4BcAAEUDAACqDgAADxoAAHQFAADZEAAAPhwAAKMHAAAIEwAAbR4AANIJAAA3FQAAnAAAAAEMAABmFwAA
| ywIAADAOAACVGQAA+gQAAF8QAADEGwAAKQcAAI4SAADzHQAAWAkAAL0UAAAiAAAAhwsAAOwWAABRAgAAtg0AABsZAACABAAA
| 5Q8AAEobAACvBgAAFBIAAHkdAADeCAAAQxQAAKgfAAANCwAAchYAANcBAAA8DQAAoRgAAAYEAABrDwAA0BoAADUGAACaEQAA
| /xwAAGQIAADJEwAALh8AAJMKAAD4FQAAXQEAAMIMAAAnGAAAjAMAAPEOAABWGgAAuwUAACARAACFHAAA6gcAAE8TAAC0HgAA
| GQoAAH4VAADjAAAASAwAAK0XAAASAwAAdw4AANwZAABBBQAAphAAAAscAABwBwAA1RIAADoeAACfCQAABBUAAGkAAADOCwAA
| MxcAAJgCAAD9DQAAYhkAAMcEAAAsEAAAkRsAAPYGAABbEgAAwB0AACUJAACKFAAA7x8AAFQLAAC5FgAAHgIAAIMNAADoGAAA
| TQQAALIPAAAXGwAAfAYAAOERAABGHQAAqwgAABAUAAB1HwAA2goAAD8WAACkAQAACQ0AAG4YAADTAwAAOA8AAJ0aAAACBgAA
| ZxEAAMwcAAAxCAAAlhMAAPseAABgCgAAxRUAACoBAACPDAAA9BcAAFkDAAC+DgAAIxoAAIgFAADtEAAAUhwAALcHAAAcEwAA
| gR4AAOYJAABLFQAAsAAAABUMAAB6FwAA3wIAAEQOAACpGQAADgUAAHMQAADYGwAAPQcAAKISAAAHHgAAbAkAANEUAAA2AAAA
| mwsAAAAXAABlAgAAyg0AAC8ZAACUBAAA+Q8AAF4bAADDBgAAKBIAAI0dAADyCAAAVxQAALwfAAAhCwAAhhYAADAOAACVGQAA
| +gQAAF8QAADEGwAAKQcAAI4SAADzHQAAWAkAAL0UAAAiAAAAhwsAAOwWAABRAgAAtg0AABsZAACABAAA5Q8AAEobAACvBgAA
| FBIAAHkdAADeCAAAQxQAAKgfAAANCwAAchYAANcBAAA8DQAAoRgAAAYEAABrDwAA0BoAADUGAACaEQAA/xwAAGQIAADJEwAA
| Lh8AAJMKAAD4FQAAXQEAAMIMAAAnGAAAjAMAAPEOAABWGgAAuwUAACARAACFHAAA6gcAAE8TAAC0HgAAGQoAAH4VAADjAAAA
| SAwAAK0XAAASAwAAdw4AANwZAABBBQAAphAAAAscAABwBwAA1RIAADoeAACfCQAABBUAAGkAAADOCwAAMxcAAJgCAAD9DQAA
| YhkAAMcEAAAsEAAAkRsAAPYGAABbEgAAwB0AACUJAACKFAAA7x8AAFQLAAC5FgAAHgIAAIMNAADoGAAATQQAALIPAAAXGwAA
| fAYAAOERAABGHQAAqwgAABAUAAB1HwAA2goAAD8WAACkAQAACQ0AAG4YAADTAwAAOA8AAJ0aAAACBgAAZxEAAMwcAAAxCAAA
| lhMAAPseAABgCgAAxRUAACoBAACPDAAA9BcAAFkDAAC+DgAAIxoAAIgFAADtEAAAUhwAALcHAAAcEwAAgR4AAOYJAABLFQAA
| sAAAABUMAAB6FwAA3wIAAEQOAACpGQAADgUAAHMQAADYGwAAPQcAAKISAAAHHgAAbAkAANEUAAA2AAAAmwsAAAAXAABlAgAA
| yg0AAC8ZAACUBAAA+Q8AAF4bAADDBgAAKBIAAI0dAADyCAAAVxQAALwfAAAhCwAAhhYAAOsBAABQDQAAtRgAABoEAAB/DwAA
| 5BoAAEkGAACuEQAAEx0AAHgIAADdEwAAQh8AAKcKAAAMFgAAcQEAANYMAAA7GAAAoAMAAAUPAABqGgAAzwUAADQRAACZHAAA
| /gcAAGMTAADIHgAALQoAAJIVAAD3AAAAXAwAAMEXAAAmAwAAiw4AAPAZAABVBQAAuhAAAB8cAACEBwAA6RIAAE4eAACzCQAA
| GBUAAH0AAADiCwAARxcAAKwCAAARDgAAdhkAANsEAABAEAAApRsAAAoHAABvEgAA1B0AADkJAACeFAAAAwAAAGgLAADNFgAA
| MgIAAJcNAAD8GAAAYQQAAMYPAAArGwAAkAYAAPURAABaHQAAvwgAACQUAACJHwAA7goAAFMWAAC4AQAAHQ0AAIIYAADnAwAA
| TA8AALEaAAAWBgAAexEAAOAcAABFCAAAqhMAAA8fAAB0CgAA2RUAAD4BAACjDAAACBgAAG0DAADSDgAANxoAAJwFAAABEQAA
| ZhwAAMsHAAB1HwAA2goAAD8WAACkAQAACQ0AAG4YAADTAwAAOA8AAJ0aAAACBgAAZxEAAMwcAAAxCAAAlhMAAPseAABgCgAA
| xRUAACoBAACPDAAA9BcAAFkDAAC+DgAAIxoAAIgFAADtEAAAUhwAALcHAAAcEwAAgR4AAOYJAABLFQAAsAAAABUMAAB6FwAA
| 3wIAAEQOAACpGQAADgUAAHMQAADYGwAAPQcAAKISAAAHHgAAbAkAANEUAAA2AAAAmwsAAAAXAABlAgAAyg0AAC8ZAACUBAAA
| +Q8AAF4bAADDBgAAKBIAAI0dAADyCAAAVxQAALwfAAAhCwAAhhYAAOsBAABQDQAAtRgAABoEAAB/DwAA5BoAAEkGAACuEQAA
| Ex0AAHgIAADdEwAAQh8AAKcKAAAMFgAAcQEAANYMAAA7GAAAoAMAAAUPAABqGgAAzwUAADQRAACZHAAA/gcAAGMTAADIHgAA
| LQoAAJIVAAD3AAAAXAwAAMEXAAAmAwAAiw4AAPAZAABVBQAAuhAAAB8cAACEBwAA6RIAAE4eAACzCQAAGBUAAH0AAADiCwAA
| RxcAAKwCAAARDgAAdhkAANsEAABAEAAApRsAAAoHAABvEgAA1B0AADkJAACeFAAAAwAAAGgLAADNFgAAMgIAAJcNAAD8GAAA
| YQQAAMYPAAArGwAAkAYAAPURAABaHQAAvwgAACQUAACJHwAA7goAAFMWAAC4AQAAHQ0AAIIYAADnAwAATA8AALEaAAAWBgAA
| exEAAOAcAABFCAAAqhMAAA8fAAB0CgAA2RUAAD4BAACjDAAACBgAAG0DAADSDgAANxoAAJwFAAABEQAAZhwAAMsHAAAwEwAA
| lR4AAPoJAABfFQAAxAAAACkMAACOFwAA8wIAAFgOAAC9GQAAIgUAAIcQAADsGwAAUQcAALYSAAAbHgAAgAkAAOUUAABKAAAA
| rwsAABQXAAB5AgAA3g0AAEMZAACoBAAADRAAAHIbAADXBgAAPBIAAKEdAAAGCQAAaxQAANAfAAA1CwAAmhYAAP8BAABkDQAA
| yRgAAC4EAACTDwAA+BoAAF0GAADCEQAAJx0AAIwIAADxEwAAVh8AALsKAAAgFgAAhQEAAOoMAABPGAAAtAMAABkPAAB+GgAA
| 4wUAAEgRAACtHAAAEggAAHcTAADcHgAAQQoAAKYVAAALAQAAcAwAANUXAAA6AwAAnw4AAAQaAABpBQAAzhAAADMcAACYBwAA
| /RIAAGIeAADHCQAALBUAAJEAAAD2CwAAWxcAAMACAAAlDgAAihkAAO8EAABUEAAAuRsAAB4HAACDEgAA6B0AAE0JAACyFAAA
| FwAAAHwLAADhFgAARgIAAKsNAAAQGQAAuhAAAB8cAACEBwAA6RIAAE4eAACzCQAAGBUAAH0AAADiCwAARxcAAKwCAAARDgAA
| dhkAANsEAABAEAAApRsAAAoHAABvEgAA1B0AADkJAACeFAAAAwAAAGgLAADNFgAAMgIAAJcNAAD8GAAAYQQAAMYPAAArGwAA
| kAYAAPURAABaHQAAvwgAACQUAACJHwAA7goAAFMWAAC4AQAAHQ0AAIIYAADnAwAATA8AALEaAAAWBgAAexEAAOAcAABFCAAA
| qhMAAA8fAAB0CgAA2RUAAD4BAACjDAAACBgAAG0DAADSDgAANxoAAJwFAAABEQAAZhwAAMsHAAAwEwAAlR4AAPoJAABfFQAA
| xAAAACkMAACOFwAA8wIAAFgOAAC9GQAAIgUAAIcQAADsGwAAUQcAALYSAAAbHgAAgAkAAOUUAABKAAAArwsAABQXAAB5AgAA
| 3g0AAEMZAACoBAAADRAAAHIbAADXBgAAPBIAAKEdAAAGCQAAaxQAANAfAAA1CwAAmhYAAP8BAABkDQAAyRgAAC4EAACTDwAA
| +BoAAF0GAADCEQAAJx0AAIwIAADxEwAAVh8AALsKAAAgFgAAhQEAAOoMAABPGAAAtAMAABkPAAB+GgAA4wUAAEgRAACtHAAA
| EggAAHcTAADcHgAAQQoAAKYVAAALAQAAcAwAANUXAAA6AwAAnw4AAAQaAABpBQAAzhAAADMcAACYBwAA/RIAAGIeAADHCQAA
| LBUAAJEAAAD2CwAAWxcAAMACAAAlDgAAihkAAO8EAABUEAAAuRsAAB4HAACDEgAA6B0AAE0JAACyFAAAFwAAAHwLAADhFgAA
| RgIAAKsNAAAQGQAAdQQAANoPAAA/GwAApAYAAAkSAABuHQAA0wgAADgUAACdHwAAAgsAAGcWAADMAQAAMQ0AAJYYAAD7AwAA
| YA8AAMUaAAAqBgAAjxEAAPQcAABZCAAAvhMAACMfAACICgAA7RUAAFIBAAC3DAAAHBgAAIEDAADmDgAASxoAALAFAAAVEQAA
| ehwAAN8HAABEEwAAqR4AAA4KAABzFQAA2AAAAD0MAACiFwAABwMAAGwOAADRGQAANgUAAJsQAAAAHAAAZQcAAMoSAAAvHgAA
| lAkAAPkUAABeAAAAwwsAACgXAACNAgAA8g0AAFcZAAC8BAAAIRAAAIYbAADrBgAAUBIAALUdAAAaCQAAfxQAAOQfAABJCwAA
| rhYAABMCAAB4DQAA3RgAAEIEAACnDwAADBsAAHEGAADWEQAAOx0AAKAIAAAFFAAAah8AAM8KAAA0FgAAmQEAAP4MAABjGAAA
| yAMAAC0PAACSGgAA9wUAAFwRAADBHAAAJggAAIsTAADwHgAAVQoAAP8BAABkDQAAyRgAAC4EAACTDwAA+BoAAF0GAADCEQAA
| Jx0AAIwIAADxEwAAVh8AALsKAAAgFgAAhQEAAOoMAABPGAAAtAMAABkPAAB+GgAA4wUAAEgRAACtHAAAEggAAHcTAADcHgAA
| QQoAAKYVAAALAQAAcAwAANUXAAA6AwAAnw4AAAQaAABpBQAAzhAAADMcAACYBwAA/RIAAGIeAADHCQAALBUAAJEAAAD2CwAA
| WxcAAMACAAAlDgAAihkAAO8EAABUEAAAuRsAAB4HAACDEgAA6B0AAE0JAACyFAAAFwAAAHwLAADhFgAARgIAAKsNAAAQGQAA
| dQQAANoPAAA/GwAApAYAAAkSAABuHQAA0wgAADgUAACdHwAAAgsAAGcWAADMAQAAMQ0AAJYYAAD7AwAAYA8AAMUaAAAqBgAA
| jxEAAPQcAABZCAAAvhMAACMfAACICgAA7RUAAFIBAAC3DAAAHBgAAIEDAADmDgAASxoAALAFAAAVEQAAehwAAN8HAABEEwAA
| qR4AAA4KAABzFQAA2AAAAD0MAACiFwAABwMAAGwOAADRGQAANgUAAJsQAAAAHAAAZQcAAMoSAAAvHgAAlAkAAPkUAABeAAAA
| wwsAACgXAACNAgAA8g0AAFcZAAC8BAAAIRAAAIYbAADrBgAAUBIAALUdAAAaCQAAfxQAAOQfAABJCwAArhYAABMCAAB4DQAA
| 3RgAAEIEAACnDwAADBsAAHEGAADWEQAAOx0AAKAIAAAFFAAAah8AAM8KAAA0FgAAmQEAAP4MAABjGAAAyAMAAC0PAACSGgAA
| 9wUAAFwRAADBHAAAJggAAIsTAADwHgAAVQoAALoVAAAfAQAAhAwAAOkXAABOAwAAsw4AABgaAAB9BQAA4hAAAEccAACsBwAA
| ERMAAHYeAADbCQAAQBUAAKUAAAAKDAAAbxcAANQCAAA5DgAAnhkAAAMFAABoEAAAzRsAADIHAACXEgAA/B0AAGEJAADGFAAA
| KwAAAJALAAD1FgAAWgIAAL8NAAAkGQAAiQQAAO4PAABTGwAAuAYAAB0SAACCHQAA5wgAAEwUAACxHwAAFgsAAHsWAADgAQAA
| RQ0AAKoYAAAPBAAAdA8AANkaAAA+BgAAoxEAAAgdAABtCAAA0hMAADcfAACcCgAAARYAAGYBAADLDAAAMBgAAJUDAAD6DgAA
| XxoAAMQFAAApEQAAjhwAAPMHAABYEwAAvR4AACIKAACHFQAA7AAAAFEMAAC2FwAAGwMAAIAOAADlGQAASgUAAK8QAAAUHAAA
| eQcAAN4SAABDHgAAqAkAAA0VAAByAAAA1wsAADwXAAChAgAABg4AAGsZAADQBAAANRAAAJobAABEEwAAqR4AAA4KAABzFQAA
| 2AAAAD0MAACiFwAABwMAAGwOAADRGQAANgUAAJsQAAAAHAAAZQcAAMoSAAAvHgAAlAkAAPkUAABeAAAAwwsAACgXAACNAgAA
| 8g0AAFcZAAC8BAAAIRAAAIYbAADrBgAAUBIAALUdAAAaCQAAfxQAAOQfAABJCwAArhYAABMCAAB4DQAA3RgAAEIEAACnDwAA
| DBsAAHEGAADWEQAAOx0AAKAIAAAFFAAAah8AAM8KAAA0FgAAmQEAAP4MAABjGAAAyAMAAC0PAACSGgAA9wUAAFwRAADBHAAA
| JggAAIsTAADwHgAAVQoAALoVAAAfAQAAhAwAAOkXAABOAwAAsw4AABgaAAB9BQAA4hAAAEccAACsBwAAERMAAHYeAADbCQAA
| QBUAAKUAAAAKDAAAbxcAANQCAAA5DgAAnhkAAAMFAABoEAAAzRsAADIHAACXEgAA/B0AAGEJAADGFAAAKwAAAJALAAD1FgAA
| WgIAAL8NAAAkGQAAiQQAAO4PAABTGwAAuAYAAB0SAACCHQAA5wgAAEwUAACxHwAAFgsAAHsWAADgAQAARQ0AAKoYAAAPBAAA
| dA8AANkaAAA+BgAAoxEAAAgdAABtCAAA0hMAADcfAACcCgAAARYAAGYBAADLDAAAMBgAAJUDAAD6DgAAXxoAAMQFAAApEQAA
| jhwAAPMHAABYEwAAvR4AACIKAACHFQAA7AAAAFEMAAC2FwAAGwMAAIAOAADlGQAASgUAAK8QAAAUHAAAeQcAAN4SAABDHgAA
| qAkAAA0VAAByAAAA1wsAADwXAAChAgAABg4AAGsZAADQBAAANRAAAJobAAD/BgAAZBIAAMkdAAAuCQAAkxQAAPgfAABdCwAA
| whYAACcCAACMDQAA8RgAAFYEAAC7DwAAIBsAAIUGAADqEQAATx0AALQIAAAZFAAAfh8AAOMKAABIFgAArQEAABINAAB3GAAA
| 3AMAAEEPAACmGgAACwYAAHARAADVHAAAOggAAJ8TAAAEHwAAaQoAAM4VAAAzAQAAmAwAAP0XAABiAwAAxw4AACwaAACRBQAA
| 9hAAAFscAADABwAAJRMAAIoeAADvCQAAVBUAALkAAAAeDAAAgxcAAOgCAABNDgAAshkAABcFAAB8EAAA4RsAAEYHAACrEgAA
| EB4AAHUJAADaFAAAPwAAAKQLAAAJFwAAbgIAANMNAAA4GQAAnQQAAAIQAABnGwAAzAYAADESAACWHQAA+wgAAGAUAADFHwAA
| KgsAAI8WAAD0AQAAWQ0AAL4YAAAjBAAAiA8AAO0aAABSBgAAtxEAABwdAACBCAAA5hMAAEsfAACwCgAAFRYAAHoBAADfDAAA
| iQQAAO4PAABTGwAAuAYAAB0SAACCHQAA5wgAAEwUAACxHwAAFgsAAHsWAADgAQAARQ0AAKoYAAAPBAAAdA8AANkaAAA+BgAA
| oxEAAAgdAABtCAAA0hMAADcfAACcCgAAARYAAGYBAADLDAAAMBgAAJUDAAD6DgAAXxoAAMQFAAApEQAAjhwAAPMHAABYEwAA
| vR4AACIKAACHFQAA7AAAAFEMAAC2FwAAGwMAAIAOAADlGQAASgUAAK8QAAAUHAAAeQcAAN4SAABDHgAAqAkAAA0VAAByAAAA
| 1wsAADwXAAChAgAABg4AAGsZAADQBAAANRAAAJobAAD/BgAAZBIAAMkdAAAuCQAAkxQAAPgfAABdCwAAwhYAACcCAACMDQAA
| 8RgAAFYEAAC7DwAAIBsAAIUGAADqEQAATx0AALQIAAAZFAAAfh8AAOMKAABIFgAArQEAABINAAB3GAAA3AMAAEEPAACmGgAA
| CwYAAHARAADVHAAAOggAAJ8TAAAEHwAAaQoAAM4VAAAzAQAAmAwAAP0XAABiAwAAxw4AACwaAACRBQAA9hAAAFscAADABwAA
| JRMAAIoeAADvCQAAVBUAALkAAAAeDAAAgxcAAOgCAABNDgAAshkAABcFAAB8EAAA4RsAAEYHAACrEgAAEB4AAHUJAADaFAAA
| PwAAAKQLAAAJFwAAbgIAANMNAAA4GQAAnQQAAAIQAABnGwAAzAYAADESAACWHQAA+wgAAGAUAADFHwAAKgsAAI8WAAD0AQAA
| WQ0AAL4YAAAjBAAAiA8AAO0aAABSBgAAtxEAABwdAACBCAAA5hMAAEsfAACwCgAAFRYAAHoBAADfDAAARBgAAKkDAAAODwAA
| cxoAANgFAAA9EQAAohwAAAcIAABsEwAA0R4AADYKAACbFQAAAAEAAGUMAADKFwAALwMAAJQOAAD5GQAAXgUAAMMQAAAoHAAA
| jQcAAPISAABXHgAAvAkAACEVAACGAAAA6wsAAFAXAAC1AgAAGg4AAH8ZAADkBAAASRAAAK4bAAATBwAAeBIAAN0dAABCCQAA
| pxQAAAwAAABxCwAA1hYAADsCAACgDQAABRkAAGoEAADPDwAANBsAAJkGAAD+EQAAYx0AAMgIAAAtFAAAkh8AAPcKAABcFgAA
| wQEAACYNAACLGAAA8AMAAFUPAAC6GgAAHwYAAIQRAADpHAAATggAALMTAAAYHwAAfQoAAOIVAABHAQAArAwAABEYAAB2AwAA
| 2w4AAEAaAAClBQAAChEAAG8cAADUBwAAORMAAJ4eAAADCgAAaBUAAM0AAAAyDAAAlxcAAPwCAABhDgAAxhkAACsFAACQEAAA
| 9RsAAFoHAAC/EgAAJB4AAM4VAAAzAQAAmAwAAP0XAABiAwAAxw4AACwaAACRBQAA9hAAAFscAADABwAAJRMAAIoeAADvCQAA
| VBUAALkAAAAeDAAAgxcAAOgCAABNDgAAshkAABcFAAB8EAAA4RsAAEYHAACrEgAAEB4AAHUJAADaFAAAPwAAAKQLAAAJFwAA
| bgIAANMNAAA4GQAAnQQAAAIQAABnGwAAzAYAADESAACWHQAA+wgAAGAUAADFHwAAKgsAAI8WAAD0AQAAWQ0AAL4YAAAjBAAA
| iA8AAO0aAABSBgAAtxEAABwdAACBCAAA5hMAAEsfAACwCgAAFRYAAHoBAADfDAAARBgAAKkDAAAODwAAcxoAANgFAAA9EQAA
| ohwAAAcIAABsEwAA0R4AADYKAACbFQAAAAEAAGUMAADKFwAALwMAAJQOAAD5GQAAXgUAAMMQAAAoHAAAjQcAAPISAABXHgAA
| vAkAACEVAACGAAAA6wsAAFAXAAC1AgAAGg4AAH8ZAADkBAAASRAAAK4bAAATBwAAeBIAAN0dAABCCQAApxQAAAwAAABxCwAA
| 1hYAADsCAACgDQAABRkAAGoEAADPDwAANBsAAJkGAAD+EQAAYx0AAMgIAAAtFAAAkh8AAPcKAABcFgAAwQEAACYNAACLGAAA
| 8AMAAFUPAAC6GgAAHwYAAIQRAADpHAAATggAALMTAAAYHwAAfQoAAOIVAABHAQAArAwAABEYAAB2AwAA2w4AAEAaAAClBQAA
| ChEAAG8cAADUBwAAORMAAJ4eAAADCgAAaBUAAM0AAAAyDAAAlxcAAPwCAABhDgAAxhkAACsFAACQEAAA9RsAAFoHAAC/EgAA
| JB4AAIkJAADuFAAAUwAAALgLAAAdFwAAggIAAOcNAABMGQAAsQQAABYQAAB7GwAA4AYAAEUSAACqHQAADwkAAHQUAADZHwAA
| PgsAAKMWAAAIAgAAbQ0AANIYAAA3BAAAnA8AAAEbAABmBgAAyxEAADAdAACVCAAA+hMAAF8fAADECgAAKRYAAI4BAADzDAAA
| WBgAAL0DAAAiDwAAhxoAAOwFAABREQAAthwAABsIAACAEwAA5R4AAEoKAACvFQAAFAEAAHkMAADeFwAAQwMAAKgOAAANGgAA
| cgUAANcQAAA8HAAAoQcAAAYTAABrHgAA0AkAADUVAACaAAAA/wsAAGQXAADJAgAALg4AAJMZAAD4BAAAXRAAAMIbAAAnBwAA
| jBIAAPEdAABWCQAAuxQAACAAAACFCwAA6hYAAE8CAAC0DQAAGRkAAH4EAADjDwAASBsAAK0GAAASEgAAdx0AANwIAABBFAAA
| ph8AAAsLAABwFgAA1QEAADoNAACfGAAABAQAAGkPAAATBwAAeBIAAN0dAABCCQAApxQAAAwAAABxCwAA1hYAADsCAACgDQAA
| BRkAAGoEAADPDwAANBsAAJkGAAD+EQAAYx0AAMgIAAAtFAAAkh8AAPcKAABcFgAAwQEAACYNAACLGAAA8AMAAFUPAAC6GgAA
| HwYAAIQRAADpHAAATggAALMTAAAYHwAAfQoAAOIVAABHAQAArAwAABEYAAB2AwAA2w4AAEAaAAClBQAAChEAAG8cAADUBwAA
| ORMAAJ4eAAADCgAAaBUAAM0AAAAyDAAAlxcAAPwCAABhDgAAxhkAACsFAACQEAAA9RsAAFoHAAC/EgAAJB4AAIkJAADuFAAA
| UwAAALgLAAAdFwAAggIAAOcNAABMGQAAsQQAABYQAAB7GwAA4AYAAEUSAACqHQAADwkAAHQUAADZHwAAPgsAAKMWAAAIAgAA
| bQ0AANIYAAA3BAAAnA8AAAEbAABmBgAAyxEAADAdAACVCAAA+hMAAF8fAADECgAAKRYAAI4BAADzDAAAWBgAAL0DAAAiDwAA
| hxoAAOwFAABREQAAthwAABsIAACAEwAA5R4AAEoKAACvFQAAFAEAAHkMAADeFwAAQwMAAKgOAAANGgAAcgUAANcQAAA8HAAA
| oQcAAAYTAABrHgAA0AkAADUVAACaAAAA/wsAAGQXAADJAgAALg4AAJMZAAD4BAAAXRAAAMIbAAAnBwAAjBIAAPEdAABWCQAA
| uxQAACAAAACFCwAA6hYAAE8CAAC0DQAAGRkAAH4EAADjDwAASBsAAK0GAAASEgAAdx0AANwIAABBFAAAph8AAAsLAABwFgAA
| 1QEAADoNAACfGAAABAQAAGkPAADOGgAAMwYAAJgRAAD9HAAAYggAAMcTAAAsHwAAkQoAAPYVAABbAQAAwAwAACUYAACKAwAA
| 7w4AAFQaAAC5BQAAHhEAAIMcAADoBwAATRMAALIeAAAXCgAAfBUAAOEAAABGDAAAqxcAABADAAB1DgAA2hkAAD8FAACkEAAA
| CRwAAG4HAADTEgAAOB4AAJ0JAAACFQAAZwAAAMwLAAAxFwAAlgIAAPsNAABgGQAAxQQAACoQAACPGwAA9AYAAFkSAAC+HQAA
| IwkAAIgUAADtHwAAUgsAALcWAAAcAgAAgQ0AAOYYAABLBAAAsA8AABUbAAB6BgAA3xEAAEQdAACpCAAADhQAAHMfAADYCgAA
| PRYAAKIBAAAHDQAAbBgAANEDAAA2DwAAmxoAAAAGAABlEQAAyhwAAC8IAACUEwAA+R4AAF4KAADDFQAAKAEAAI0MAADyFwAA
| VwMAALwOAAAhGgAAhgUAAOsQAABQHAAAtQcAABoTAAB/HgAA5AkAAEkVAACuAAAAWBgAAL0DAAAiDwAAhxoAAOwFAABREQAA
| thwAABsIAACAEwAA5R4AAEoKAACvFQAAFAEAAHkMAADeFwAAQwMAAKgOAAANGgAAcgUAANcQAAA8HAAAoQcAAAYTAABrHgAA
| 0AkAADUVAACaAAAA/wsAAGQXAADJAgAALg4AAJMZAAD4BAAAXRAAAMIbAAAnBwAAjBIAAPEdAABWCQAAuxQAACAAAACFCwAA
| 6hYAAE8CAAC0DQAAGRkAAH4EAADjDwAASBsAAK0GAAASEgAAdx0AANwIAABBFAAAph8AAAsLAABwFgAA1QEAADoNAACfGAAA
| BAQAAGkPAADOGgAAMwYAAJgRAAD9HAAAYggAAMcTAAAsHwAAkQoAAPYVAABbAQAAwAwAACUYAACKAwAA7w4AAFQaAAC5BQAA
| HhEAAIMcAADoBwAATRMAALIeAAAXCgAAfBUAAOEAAABGDAAAqxcAABADAAB1DgAA2hkAAD8FAACkEAAACRwAAG4HAADTEgAA
| OB4AAJ0JAAACFQAAZwAAAMwLAAAxFwAAlgIAAPsNAABgGQAAxQQAACoQAACPGwAA9AYAAFkSAAC+HQAAIwkAAIgUAADtHwAA
| UgsAALcWAAAcAgAAgQ0AAOYYAABLBAAAsA8AABUbAAB6BgAA3xEAAEQdAACpCAAADhQAAHMfAADYCgAAPRYAAKIBAAAHDQAA
| bBgAANEDAAA2DwAAmxoAAAAGAABlEQAAyhwAAC8IAACUEwAA+R4AAF4KAADDFQAAKAEAAI0MAADyFwAAVwMAALwOAAAhGgAA
| hgUAAOsQAABQHAAAtQcAABoTAAB/HgAA5AkAAEkVAACuAAAAEwwAAHgXAADdAgAAQg4AAKcZAAAMBQAAcRAAANYbAAA7BwAA
| oBIAAAUeAABqCQAAzxQAADQAAACZCwAA/hYAAGMCAADIDQAALRkAAJIEAAD3DwAAXBsAAMEGAAAmEgAAix0AAPAIAABVFAAA
| uh8AAB8LAACEFgAA6QEAAE4NAACzGAAAGAQAAH0PAADiGgAARwYAAKwRAAARHQAAdggAANsTAABAHwAApQoAAAoWAABvAQAA
| 1AwAADkYAACeAwAAAw8AAGgaAADNBQAAMhEAAJccAAD8BwAAYRMAAMYeAAArCgAAkBUAAPUAAABaDAAAvxcAACQDAACJDgAA
| 7hkAAFMFAAC4EAAAHRwAAIIHAADnEgAATB4AALEJAAAWFQAAewAAAOALAABFFwAAqgIAAA8OAAB0GQAA2QQAAD4QAACjGwAA
| CAcAAG0SAADSHQAANwkAAJwUAAABAAAAZgsAAMsWAAAwAgAAlQ0AAPoYAABfBAAAxA8AACkbAACOBgAA8xEAAJ0JAAACFQAA
| ZwAAAMwLAAAxFwAAlgIAAPsNAABgGQAAxQQAACoQAACPGwAA9AYAAFkSAAC+HQAAIwkAAIgUAADtHwAAUgsAALcWAAAcAgAA
| gQ0AAOYYAABLBAAAsA8AABUbAAB6BgAA3xEAAEQdAACpCAAADhQAAHMfAADYCgAAPRYAAKIBAAAHDQAAbBgAANEDAAA2DwAA
| mxoAAAAGAABlEQAAyhwAAC8IAACUEwAA+R4AAF4KAADDFQAAKAEAAI0MAADyFwAAVwMAALwOAAAhGgAAhgUAAOsQAABQHAAA
| tQcAABoTAAB/HgAA5AkAAEkVAACuAAAAEwwAAHgXAADdAgAAQg4AAKcZAAAMBQAAcRAAANYbAAA7BwAAoBIAAAUeAABqCQAA
| zxQAADQAAACZCwAA/hYAAGMCAADIDQAALRkAAJIEAAD3DwAAXBsAAMEGAAAmEgAAix0AAPAIAABVFAAAuh8AAB8LAACEFgAA
| 6QEAAE4NAACzGAAAGAQAAH0PAADiGgAARwYAAKwRAAARHQAAdggAANsTAABAHwAApQoAAAoWAABvAQAA1AwAADkYAACeAwAA
| Aw8AAGgaAADNBQAAMhEAAJccAAD8BwAAYRMAAMYeAAArCgAAkBUAAPUAAABaDAAAvxcAACQDAACJDgAA7hkAAFMFAAC4EAAA
| HRwAAIIHAADnEgAATB4AALEJAAAWFQAAewAAAOALAABFFwAAqgIAAA8OAAB0GQAA2QQAAD4QAACjGwAACAcAAG0SAADSHQAA
| NwkAAJwUAAABAAAAZgsAAMsWAAAwAgAAlQ0AAPoYAABfBAAAxA8AACkbAACOBgAA8xEAAFgdAAC9CAAAIhQAAIcfAADsCgAA
| URYAALYBAAAbDQAAgBgAAOUDAABKDwAArxoAABQGAAB5EQAA3hwAAEMIAACoEwAADR8AAHIKAADXFQAAPAEAAKEMAAAGGAAA
| awMAANAOAAA1GgAAmgUAAP8QAABkHAAAyQcAAC4TAACTHgAA+AkAAF0VAADCAAAAJwwAAIwXAADxAgAAVg4AALsZAAAgBQAA
| hRAAAOobAABPBwAAtBIAABkeAAB+CQAA4xQAAEgAAACtCwAAEhcAAHcCAADcDQAAQRkAAKYEAAALEAAAcBsAANUGAAA6EgAA
| nx0AAAQJAABpFAAAzh8AADMLAACYFgAA/QEAAGINAADHGAAALAQAAJEPAAD2GgAAWwYAAMARAAAlHQAAiggAAO8TAABUHwAA
| uQoAAB4WAACDAQAA6AwAAE0YAACyAwAAFw8AAHwaAADhBQAARhEAAKscAAAQCAAAdRMAANoeAAA/CgAApBUAAAkBAABuDAAA
| 0xcAADgDAADiGgAARwYAAKwRAAARHQAAdggAANsTAABAHwAApQoAAAoWAABvAQAA1AwAADkYAACeAwAAAw8AAGgaAADNBQAA
| MhEAAJccAAD8BwAAYRMAAMYeAAArCgAAkBUAAPUAAABaDAAAvxcAACQDAACJDgAA7hkAAFMFAAC4EAAAHRwAAIIHAADnEgAA
| TB4AALEJAAAWFQAAewAAAOALAABFFwAAqgIAAA8OAAB0GQAA2QQAAD4QAACjGwAACAcAAG0SAADSHQAANwkAAJwUAAABAAAA
| ZgsAAMsWAAAwAgAAlQ0AAPoYAABfBAAAxA8AACkbAACOBgAA8xEAAFgdAAC9CAAAIhQAAIcfAADsCgAAURYAALYBAAAbDQAA
| gBgAAOUDAABKDwAArxoAABQGAAB5EQAA3hwAAEMIAACoEwAADR8AAHIKAADXFQAAPAEAAKEMAAAGGAAAawMAANAOAAA1GgAA
| mgUAAP8QAABkHAAAyQcAAC4TAACTHgAA+AkAAF0VAADCAAAAJwwAAIwXAADxAgAAVg4AALsZAAAgBQAAhRAAAOobAABPBwAA
| tBIAABkeAAB+CQAA4xQAAEgAAACtCwAAEhcAAHcCAADcDQAAQRkAAKYEAAALEAAAcBsAANUGAAA6EgAAnx0AAAQJAABpFAAA
| zh8AADMLAACYFgAA/QEAAGINAADHGAAALAQAAJEPAAD2GgAAWwYAAMARAAAlHQAAiggAAO8TAABUHwAAuQoAAB4WAACDAQAA
| 6AwAAE0YAACyAwAAFw8AAHwaAADhBQAARhEAAKscAAAQCAAAdRMAANoeAAA/CgAApBUAAAkBAABuDAAA0xcAADgDAACdDgAA
| AhoAAGcFAADMEAAAMRwAAJYHAAD7EgAAYB4AAMUJAAAqFQAAjwAAAPQLAABZFwAAvgIAACMOAACIGQAA7QQAAFIQAAC3GwAA
| HAcAAIESAADmHQAASwkAALAUAAAVAAAAegsAAN8WAABEAgAAqQ0AAA4ZAABzBAAA2A8AAD0bAACiBgAABxIAAGwdAADRCAAA
| NhQAAJsfAAAACwAAZRYAAMoBAAAvDQAAlBgAAPkDAABeDwAAwxoAACgGAACNEQAA8hwAAFcIAAC8EwAAIR8AAIYKAADrFQAA
| UAEAALUMAAAaGAAAfwMAAOQOAABJGgAArgUAABMRAAB4HAAA3QcAAEITAACnHgAADAoAAHEVAADWAAAAOwwAAKAXAAAFAwAA
| ag4AAM8ZAAA0BQAAmRAAAP4bAABjBwAAyBIAAC0eAACSCQAA9xQAAFwAAADBCwAAJhcAAIsCAADwDQAAVRkAALoEAAAfEAAA
| hBsAAOkGAABOEgAAsx0AABgJAAB9FAAAJwwAAIwXAADxAgAAVg4AALsZAAAgBQAAhRAAAOobAABPBwAAtBIAABkeAAB+CQAA
| 4xQAAEgAAACtCwAAEhcAAHcCAADcDQAAQRkAAKYEAAALEAAAcBsAANUGAAA6EgAAnx0AAAQJAABpFAAAzh8AADMLAACYFgAA
| /QEAAGINAADHGAAALAQAAJEPAAD2GgAAWwYAAMARAAAlHQAAiggAAO8TAABUHwAAuQoAAB4WAACDAQAA6AwAAE0YAACyAwAA
| Fw8AAHwaAADhBQAARhEAAKscAAAQCAAAdRMAANoeAAA/CgAApBUAAAkBAABuDAAA0xcAADgDAACdDgAAAhoAAGcFAADMEAAA
| MRwAAJYHAAD7EgAAYB4AAMUJAAAqFQAAjwAAAPQLAABZFwAAvgIAACMOAACIGQAA7QQAAFIQAAC3GwAAHAcAAIESAADmHQAA
| SwkAALAUAAAVAAAAegsAAN8WAABEAgAAqQ0AAA4ZAABzBAAA2A8AAD0bAACiBgAABxIAAGwdAADRCAAANhQAAJsfAAAACwAA
| ZRYAAMoBAAAvDQAAlBgAAPkDAABeDwAAwxoAACgGAACNEQAA8hwAAFcIAAC8EwAAIR8AAIYKAADrFQAAUAEAALUMAAAaGAAA
| fwMAAOQOAABJGgAArgUAABMRAAB4HAAA3QcAAEITAACnHgAADAoAAHEVAADWAAAAOwwAAKAXAAAFAwAAag4AAM8ZAAA0BQAA
| mRAAAP4bAABjBwAAyBIAAC0eAACSCQAA9xQAAFwAAADBCwAAJhcAAIsCAADwDQAAVRkAALoEAAAfEAAAhBsAAOkGAABOEgAA
| sx0AABgJAAB9FAAA4h8AAEcLAACsFgAAEQIAAHYNAADbGAAAQAQAAKUPAAAKGwAAbwYAANQRAAA5HQAAnggAAAMUAABoHwAA
| zQoAADIWAACXAQAA/AwAAGEYAADGAwAAKw8AAJAaAAD1BQAAWhEAAL8cAAAkCAAAiRMAAO4eAABTCgAAuBUAAB0BAACCDAAA
| 5xcAAEwDAACxDgAAFhoAAHsFAADgEAAARRwAAKoHAAAPEwAAdB4AANkJAAA+FQAAowAAAAgMAABtFwAA0gIAADcOAACcGQAA
| AQUAAGYQAADLGwAAMAcAAJUSAAD6HQAAXwkAAMQUAAApAAAAjgsAAPMWAABYAgAAvQ0AACIZAACHBAAA7A8AAFEbAAC2BgAA
| GxIAAIAdAADlCAAAShQAAK8fAAAUCwAAeRYAAN4BAABDDQAAqBgAAA0EAAByDwAA1xoAADwGAAChEQAABh0AAGsIAADQEwAA
| NR8AAJoKAAD/FQAAZAEAAMkMAAAuGAAAkwMAAPgOAABdGgAAwgUAAGwdAADRCAAANhQAAJsfAAAACwAAZRYAAMoBAAAvDQAA
| lBgAAPkDAABeDwAAwxoAACgGAACNEQAA8hwAAFcIAAC8EwAAIR8AAIYKAADrFQAAUAEAALUMAAAaGAAAfwMAAOQOAABJGgAA
| rgUAABMRAAB4HAAA3QcAAEITAACnHgAADAoAAHEVAADWAAAAOwwAAKAXAAAFAwAAag4AAM8ZAAA0BQAAmRAAAP4bAABjBwAA
| yBIAAC0eAACSCQAA9xQAAFwAAADBCwAAJhcAAIsCAADwDQAAVRkAALoEAAAfEAAAhBsAAOkGAABOEgAAsx0AABgJAAB9FAAA
| 4h8AAEcLAACsFgAAEQIAAHYNAADbGAAAQAQAAKUPAAAKGwAAbwYAANQRAAA5HQAAnggAAAMUAABoHwAAzQoAADIWAACXAQAA
| /AwAAGEYAADGAwAAKw8AAJAaAAD1BQAAWhEAAL8cAAAkCAAAiRMAAO4eAABTCgAAuBUAAB0BAACCDAAA5xcAAEwDAACxDgAA
| FhoAAHsFAADgEAAARRwAAKoHAAAPEwAAdB4AANkJAAA+FQAAowAAAAgMAABtFwAA0gIAADcOAACcGQAAAQUAAGYQAADLGwAA
| MAcAAJUSAAD6HQAAXwkAAMQUAAApAAAAjgsAAPMWAABYAgAAvQ0AACIZAACHBAAA7A8AAFEbAAC2BgAAGxIAAIAdAADlCAAA
| ShQAAK8fAAAUCwAAeRYAAN4BAABDDQAAqBgAAA0EAAByDwAA1xoAADwGAAChEQAABh0AAGsIAADQEwAANR8AAJoKAAD/FQAA
| ZAEAAMkMAAAuGAAAkwMAAPgOAABdGgAAwgUAACcRAACMHAAA8QcAAFYTAAC7HgAAIAoAAIUVAADqAAAATwwAALQXAAAZAwAA
| fg4AAOMZAABIBQAArRAAABIcAAB3BwAA3BIAAEEeAACmCQAACxUAAHAAAADVCwAAOhcAAJ8CAAAEDgAAaRkAAM4EAAAzEAAA
| mBsAAP0GAABiEgAAxx0AACwJAACRFAAA9h8AAFsLAADAFgAAJQIAAIoNAADvGAAAVAQAALkPAAAeGwAAgwYAAOgRAABNHQAA
| sggAABcUAAB8HwAA4QoAAEYWAACrAQAAEA0AAHUYAADaAwAAPw8AAKQaAAAJBgAAbhEAANMcAAA4CAAAnRMAAAIfAABnCgAA
| zBUAADEBAACWDAAA+xcAAGADAADFDgAAKhoAAI8FAAD0EAAAWRwAAL4HAAAjEwAAiB4AAO0JAABSFQAAtwAAABwMAACBFwAA
| 5gIAAEsOAACwGQAAFQUAAHoQAADfGwAARAcAAKkSAAAOHgAAcwkAANgUAAA9AAAAogsAAAcXAACxDgAAFhoAAHsFAADgEAAA
| RRwAAKoHAAAPEwAAdB4AANkJAAA+FQAAowAAAAgMAABtFwAA0gIAADcOAACcGQAAAQUAAGYQAADLGwAAMAcAAJUSAAD6HQAA
| XwkAAMQUAAApAAAAjgsAAPMWAABYAgAAvQ0AACIZAACHBAAA7A8AAFEbAAC2BgAAGxIAAIAdAADlCAAAShQAAK8fAAAUCwAA
| eRYAAN4BAABDDQAAqBgAAA0EAAByDwAA1xoAADwGAAChEQAABh0AAGsIAADQEwAANR8AAJoKAAD/FQAAZAEAAMkMAAAuGAAA
| kwMAAPgOAABdGgAAwgUAACcRAACMHAAA8QcAAFYTAAC7HgAAIAoAAIUVAADqAAAATwwAALQXAAAZAwAAfg4AAOMZAABIBQAA
| rRAAABIcAAB3BwAA3BIAAEEeAACmCQAACxUAAHAAAADVCwAAOhcAAJ8CAAAEDgAAaRkAAM4EAAAzEAAAmBsAAP0GAABiEgAA
| xx0AACwJAACRFAAA9h8AAFsLAADAFgAAJQIAAIoNAADvGAAAVAQAALkPAAAeGwAAgwYAAOgRAABNHQAAsggAABcUAAB8HwAA
| 4QoAAEYWAACrAQAAEA0AAHUYAADaAwAAPw8AAKQaAAAJBgAAbhEAANMcAAA4CAAAnRMAAAIfAABnCgAAzBUAADEBAACWDAAA
| +xcAAGADAADFDgAAKhoAAI8FAAD0EAAAWRwAAL4HAAAjEwAAiB4AAO0JAABSFQAAtwAAABwMAACBFwAA5gIAAEsOAACwGQAA
| FQUAAHoQAADfGwAARAcAAKkSAAAOHgAAcwkAANgUAAA9AAAAogsAAAcXAABsAgAA0Q0AADYZAACbBAAAABAAAGUbAADKBgAA
| LxIAAJQdAAD5CAAAXhQAAMMfAAAoCwAAjRYAAPIBAABXDQAAvBgAACEEAACGDwAA6xoAAFAGAAC1EQAAGh0AAH8IAADkEwAA
| SR8AAK4KAAATFgAAeAEAAN0MAABCGAAApwMAAAwPAABxGgAA1gUAADsRAACgHAAABQgAAGoTAADPHgAANAoAAJkVAAD+AAAA
| YwwAAMgXAAAtAwAAkg4AAPcZAABcBQAAwRAAACYcAACLBwAA8BIAAFUeAAC6CQAAHxUAAIQAAADpCwAAThcAALMCAAAYDgAA
| fRkAAOIEAABHEAAArBsAABEHAAB2EgAA2x0AAEAJAAClFAAACgAAAG8LAADUFgAAOQIAAJ4NAAADGQAAaAQAAM0PAAAyGwAA
| lwYAAPwRAABhHQAAxggAACsUAACQHwAA9QoAAFoWAAC/AQAAJA0AAIkYAADuAwAAUw8AALgaAAAdBgAAghEAAOccAABMCAAA
| 9h8AAFsLAADAFgAAJQIAAIoNAADvGAAAVAQAALkPAAAeGwAAgwYAAOgRAABNHQAAsggAABcUAAB8HwAA4QoAAEYWAACrAQAA
| EA0AAHUYAADaAwAAPw8AAKQaAAAJBgAAbhEAANMcAAA4CAAAnRMAAAIfAABnCgAAzBUAADEBAACWDAAA+xcAAGADAADFDgAA
| KhoAAI8FAAD0EAAAWRwAAL4HAAAjEwAAiB4AAO0JAABSFQAAtwAAABwMAACBFwAA5gIAAEsOAACwGQAAFQUAAHoQAADfGwAA
| RAcAAKkSAAAOHgAAcwkAANgUAAA9AAAAogsAAAcXAABsAgAA0Q0AADYZAACbBAAAABAAAGUbAADKBgAALxIAAJQdAAD5CAAA
| XhQAAMMfAAAoCwAAjRYAAPIBAABXDQAAvBgAACEEAACGDwAA6xoAAFAGAAC1EQAAGh0AAH8IAADkEwAASR8AAK4KAAATFgAA
| eAEAAN0MAABCGAAApwMAAAwPAABxGgAA1gUAADsRAACgHAAABQgAAGoTAADPHgAANAoAAJkVAAD+AAAAYwwAAMgXAAAtAwAA
| kg4AAPcZAABcBQAAwRAAACYcAACLBwAA8BIAAFUeAAC6CQAAHxUAAIQAAADpCwAAThcAALMCAAAYDgAAfRkAAOIEAABHEAAA
| rBsAABEHAAB2EgAA2x0AAEAJAAClFAAACgAAAG8LAADUFgAAOQIAAJ4NAAADGQAAaAQAAM0PAAAyGwAAlwYAAPwRAABhHQAA
| xggAACsUAACQHwAA9QoAAFoWAAC/AQAAJA0AAIkYAADuAwAAUw8AALgaAAAdBgAAghEAAOccAABMCAAAsRMAABYfAAB7CgAA
| 4BUAAEUBAACqDAAADxgAAHQDAADZDgAAPhoAAKMFAAAIEQAAbRwAANIHAAA3EwAAnB4AAAEKAABmFQAAywAAADAMAACVFwAA
| +gIAAF8OAADEGQAAKQUAAI4QAADzGwAAWAcAAL0SAAAiHgAAhwkAAOwUAABRAAAAtgsAABsXAACAAgAA5Q0AAEoZAACvBAAA
| FBAAAHkbAADeBgAAQxIAAKgdAAANCQAAchQAANcfAAA8CwAAoRYAAAYCAABrDQAA0BgAADUEAACaDwAA/xoAAGQGAADJEQAA
| Lh0AAJMIAAD4EwAAXR8AAMIKAAAnFgAAjAEAAPEMAABWGAAAuwMAACAPAACFGgAA6gUAAE8RAAC0HAAAGQgAAH4TAADjHgAA
| SAoAAK0VAAASAQAAdwwAANwXAABBAwAApg4AAAsaAABwBQAA1RAAADocAACfBwAABBMAAGkeAADOCQAAMxUAAJgAAAD9CwAA
| YhcAAMcCAAAsDgAAkRkAADsRAACgHAAABQgAAGoTAADPHgAANAoAAJkVAAD+AAAAYwwAAMgXAAAtAwAAkg4AAPcZAABcBQAA
| wRAAACYcAACLBwAA8BIAAFUeAAC6CQAAHxUAAIQAAADpCwAAThcAALMCAAAYDgAAfRkAAOIEAABHEAAArBsAABEHAAB2EgAA
| 2x0AAEAJAAClFAAACgAAAG8LAADUFgAAOQIAAJ4NAAADGQAAaAQAAM0PAAAyGwAAlwYAAPwRAABhHQAAxggAACsUAACQHwAA
| 9QoAAFoWAAC/AQAAJA0AAIkYAADuAwAAUw8AALgaAAAdBgAAghEAAOccAABMCAAAsRMAABYfAAB7CgAA4BUAAEUBAACqDAAA
| DxgAAHQDAADZDgAAPhoAAKMFAAAIEQAAbRwAANIHAAA3EwAAnB4AAAEKAABmFQAAywAAADAMAACVFwAA+gIAAF8OAADEGQAA
| KQUAAI4QAADzGwAAWAcAAL0SAAAiHgAAhwkAAOwUAABRAAAAtgsAABsXAACAAgAA5Q0AAEoZAACvBAAAFBAAAHkbAADeBgAA
| QxIAAKgdAAANCQAAchQAANcfAAA8CwAAoRYAAAYCAABrDQAA0BgAADUEAACaDwAA/xoAAGQGAADJEQAALh0AAJMIAAD4EwAA
| XR8AAMIKAAAnFgAAjAEAAPEMAABWGAAAuwMAACAPAACFGgAA6gUAAE8RAAC0HAAAGQgAAH4TAADjHgAASAoAAK0VAAASAQAA
| dwwAANwXAABBAwAApg4AAAsaAABwBQAA1RAAADocAACfBwAABBMAAGkeAADOCQAAMxUAAJgAAAD9CwAAYhcAAMcCAAAsDgAA
| kRkAAPYEAABbEAAAwBsAACUHAACKEgAA7x0AAFQJAAC5FAAAHgAAAIMLAADoFgAATQIAALINAAAXGQAAfAQAAOEPAABGGwAA
| qwYAABASAAB1HQAA2ggAAD8UAACkHwAACQsAAG4WAADTAQAAOA0AAJ0YAAACBAAAZw8AAMwaAAAxBgAAlhEAAPscAABgCAAA
| xRMAACofAACPCgAA9BUAAFkBAAC+DAAAIxgAAIgDAADtDgAAUhoAALcFAAAcEQAAgRwAAOYHAABLEwAAsB4AABUKAAB6FQAA
| 3wAAAEQMAACpFwAADgMAAHMOAADYGQAAPQUAAKIQAAAHHAAAbAcAANESAAA2HgAAmwkAAAAVAABlAAAAygsAAC8XAACUAgAA
| +Q0AAF4ZAADDBAAAKBAAAI0bAADyBgAAVxIAALwdAAAhCQAAhhQAAOsfAABQCwAAtRYAABoCAAB/DQAA5BgAAEkEAACuDwAA
| ExsAAHgGAADdEQAAQh0AAKcIAAAMFAAAcR8AANYKAACAAgAA5Q0AAEoZAACvBAAAFBAAAHkbAADeBgAAQxIAAKgdAAANCQAA
| chQAANcfAAA8CwAAoRYAAAYCAABrDQAA0BgAADUEAACaDwAA/xoAAGQGAADJEQAALh0AAJMIAAD4EwAAXR8AAMIKAAAnFgAA
| jAEAAPEMAABWGAAAuwMAACAPAACFGgAA6gUAAE8RAAC0HAAAGQgAAH4TAADjHgAASAoAAK0VAAASAQAAdwwAANwXAABBAwAA
| pg4AAAsaAABwBQAA1RAAADocAACfBwAABBMAAGkeAADOCQAAMxUAAJgAAAD9CwAAYhcAAMcCAAAsDgAAkRkAAPYEAABbEAAA
| wBsAACUHAACKEgAA7x0AAFQJAAC5FAAAHgAAAIMLAADoFgAATQIAALINAAAXGQAAfAQAAOEPAABGGwAAqwYAABASAAB1HQAA
| 2ggAAD8UAACkHwAACQsAAG4WAADTAQAAOA0AAJ0YAAACBAAAZw8AAMwaAAAxBgAAlhEAAPscAABgCAAAxRMAACofAACPCgAA
| 9BUAAFkBAAC+DAAAIxgAAIgDAADtDgAAUhoAALcFAAAcEQAAgRwAAOYHAABLEwAAsB4AABUKAAB6FQAA3wAAAEQMAACpFwAA
| DgMAAHMOAADYGQAAPQUAAKIQAAAHHAAAbAcAANESAAA2HgAAmwkAAAAVAABlAAAAygsAAC8XAACUAgAA+Q0AAF4ZAADDBAAA
| KBAAAI0bAADyBgAAVxIAALwdAAAhCQAAhhQAAOsfAABQCwAAtRYAABoCAAB/DQAA5BgAAEkEAACuDwAAExsAAHgGAADdEQAA
| Qh0AAKcIAAAMFAAAcR8AANYKAAA7FgAAoAEAAAUNAABqGAAAzwMAADQPAACZGgAA/gUAAGMRAADIHAAALQgAAJITAAD3HgAA
| XAoAAMEVAAAmAQAAiwwAAPAXAABVAwAAug4AAB8aAACEBQAA6RAAAE4cAACzBwAAGBMAAH0eAADiCQAARxUAAKwAAAARDAAA
| dhcAANsCAABADgAApRkAAAoFAABvEAAA1BsAADkHAACeEgAAAx4AAGgJAADNFAAAMgAAAJcLAAD8FgAAYQIAAMYNAAArGQAA
| kAQAAPUPAABaGwAAvwYAACQSAACJHQAA7ggAAFMUAAC4HwAAHQsAAIIWAADnAQAATA0AALEYAAAWBAAAew8AAOAaAABFBgAA
| qhEAAA8dAAB0CAAA2RMAAD4fAACjCgAACBYAAG0BAADSDAAANxgAAJwDAAABDwAAZhoAAMsFAAAwEQAAlRwAAPoHAABfEwAA
| xB4AACkKAACOFQAA8wAAAFgMAAC9FwAAIgMAAIcOAADsGQAAUQUAALYQAAAbHAAAxRMAACofAACPCgAA9BUAAFkBAAC+DAAA
| IxgAAIgDAADtDgAAUhoAALcFAAAcEQAAgRwAAOYHAABLEwAAsB4AABUKAAB6FQAA3wAAAEQMAACpFwAADgMAAHMOAADYGQAA
| PQUAAKIQAAAHHAAAbAcAANESAAA2HgAAmwkAAAAVAABlAAAAygsAAC8XAACUAgAA+Q0AAF4ZAADDBAAAKBAAAI0bAADyBgAA
| VxIAALwdAAAhCQAAhhQAAOsfAABQCwAAtRYAABoCAAB/DQAA5BgAAEkEAACuDwAAExsAAHgGAADdEQAAQh0AAKcIAAAMFAAA
| cR8AANYKAAA7FgAAoAEAAAUNAABqGAAAzwMAADQPAACZGgAA/gUAAGMRAADIHAAALQgAAJITAAD3HgAAXAoAAMEVAAAmAQAA
| iwwAAPAXAABVAwAAug4AAB8aAACEBQAA6RAAAE4cAACzBwAAGBMAAH0eAADiCQAARxUAAKwAAAARDAAAdhcAANsCAABADgAA
| pRkAAAoFAABvEAAA1BsAADkHAACeEgAAAx4AAGgJAADNFAAAMgAAAJcLAAD8FgAAYQIAAMYNAAArGQAAkAQAAPUPAABaGwAA
| vwYAACQSAACJHQAA7ggAAFMUAAC4HwAAHQsAAIIWAADnAQAATA0AALEYAAAWBAAAew8AAOAaAABFBgAAqhEAAA8dAAB0CAAA
| 2RMAAD4fAACjCgAACBYAAG0BAADSDAAANxgAAJwDAAABDwAAZhoAAMsFAAAwEQAAlRwAAPoHAABfEwAAxB4AACkKAACOFQAA
| 8wAAAFgMAAC9FwAAIgMAAIcOAADsGQAAUQUAALYQAAAbHAAAgAcAAOUSAABKHgAArwkAABQVAAB5AAAA3gsAAEMXAACoAgAA
| DQ4AAHIZAADXBAAAPBAAAKEbAAAGBwAAaxIAANAdAAA1CQAAmhQAAP8fAABkCwAAyRYAAC4CAACTDQAA+BgAAF0EAADCDwAA
| JxsAAIwGAADxEQAAVh0AALsIAAAgFAAAhR8AAOoKAABPFgAAtAEAABkNAAB+GAAA4wMAAEgPAACtGgAAEgYAAHcRAADcHAAA
| QQgAAKYTAAALHwAAcAoAANUVAAA6AQAAnwwAAAQYAABpAwAAzg4AADMaAACYBQAA/RAAAGIcAADHBwAALBMAAJEeAAD2CQAA
| WxUAAMAAAAAlDAAAihcAAO8CAABUDgAAuRkAAB4FAACDEAAA6BsAAE0HAACyEgAAFx4AAHwJAADhFAAARgAAAKsLAAAQFwAA
| dQIAANoNAAA/GQAApAQAAAkQAABuGwAA0wYAADgSAACdHQAAAgkAAGcUAADMHwAAMQsAAJYWAAD7AQAAYA0AAAoFAABvEAAA
| 1BsAADkHAACeEgAAAx4AAGgJAADNFAAAMgAAAJcLAAD8FgAAYQIAAMYNAAArGQAAkAQAAPUPAABaGwAAvwYAACQSAACJHQAA
| 7ggAAFMUAAC4HwAAHQsAAIIWAADnAQAATA0AALEYAAAWBAAAew8AAOAaAABFBgAAqhEAAA8dAAB0CAAA2RMAAD4fAACjCgAA
| CBYAAG0BAADSDAAANxgAAJwDAAABDwAAZhoAAMsFAAAwEQAAlRwAAPoHAABfEwAAxB4AACkKAACOFQAA8wAAAFgMAAC9FwAA
| IgMAAIcOAADsGQAAUQUAALYQAAAbHAAAgAcAAOUSAABKHgAArwkAABQVAAB5AAAA3gsAAEMXAACoAgAADQ4AAHIZAADXBAAA
| PBAAAKEbAAAGBwAAaxIAANAdAAA1CQAAmhQAAP8fAABkCwAAyRYAAC4CAACTDQAA+BgAAF0EAADCDwAAJxsAAIwGAADxEQAA
| Vh0AALsIAAAgFAAAhR8AAOoKAABPFgAAtAEAABkNAAB+GAAA4wMAAEgPAACtGgAAEgYAAHcRAADcHAAAQQgAAKYTAAALHwAA
| cAoAANUVAAA6AQAAnwwAAAQYAABpAwAAzg4AADMaAACYBQAA/RAAAGIcAADHBwAALBMAAJEeAAD2CQAAWxUAAMAAAAAlDAAA
| ihcAAO8CAABUDgAAuRkAAB4FAACDEAAA6BsAAE0HAACyEgAAFx4AAHwJAADhFAAARgAAAKsLAAAQFwAAdQIAANoNAAA/GQAA
| pAQAAAkQAABuGwAA0wYAADgSAACdHQAAAgkAAGcUAADMHwAAMQsAAJYWAAD7AQAAYA0AAMUYAAAqBAAAjw8AAPQaAABZBgAA
| vhEAACMdAACICAAA7RMAAFIfAAC3CgAAHBYAAIEBAADmDAAASxgAALADAAAVDwAAehoAAN8FAABEEQAAqRwAAA4IAABzEwAA
| 2B4AAD0KAACiFQAABwEAAGwMAADRFwAANgMAAJsOAAAAGgAAZQUAAMoQAAAvHAAAlAcAAPkSAABeHgAAwwkAACgVAACNAAAA
| 8gsAAFcXAAC8AgAAIQ4AAIYZAADrBAAAUBAAALUbAAAaBwAAfxIAAOQdAABJCQAArhQAABMAAAB4CwAA3RYAAEICAACnDQAA
| DBkAAHEEAADWDwAAOxsAAKAGAAAFEgAAah0AAM8IAAA0FAAAmR8AAP4KAABjFgAAyAEAAC0NAACSGAAA9wMAAFwPAADBGgAA
| JgYAAIsRAADwHAAAVQgAALoTAAAfHwAAhAoAAOkVAABOAQAAswwAABgYAAB9AwAA4g4AAEcaAACsBQAAEREAAHYcAADbBwAA
| QBMAAKUeAABPFgAAtAEAABkNAAB+GAAA4wMAAEgPAACtGgAAEgYAAHcRAADcHAAAQQgAAKYTAAALHwAAcAoAANUVAAA6AQAA
| nwwAAAQYAABpAwAAzg4AADMaAACYBQAA/RAAAGIcAADHBwAALBMAAJEeAAD2CQAAWxUAAMAAAAAlDAAAihcAAO8CAABUDgAA
| uRkAAB4FAACDEAAA6BsAAE0HAACyEgAAFx4AAHwJAADhFAAARgAAAKsLAAAQFwAAdQIAANoNAAA/GQAApAQAAAkQAABuGwAA
| 0wYAADgSAACdHQAAAgkAAGcUAADMHwAAMQsAAJYWAAD7AQAAYA0AAMUYAAAqBAAAjw8AAPQaAABZBgAAvhEAACMdAACICAAA
| 7RMAAFIfAAC3CgAAHBYAAIEBAADmDAAASxgAALADAAAVDwAAehoAAN8FAABEEQAAqRwAAA4IAABzEwAA2B4AAD0KAACiFQAA
| BwEAAGwMAADRFwAANgMAAJsOAAAAGgAAZQUAAMoQAAAvHAAAlAcAAPkSAABeHgAAwwkAACgVAACNAAAA8gsAAFcXAAC8AgAA
| IQ4AAIYZAADrBAAAUBAAALUbAAAaBwAAfxIAAOQdAABJCQAArhQAABMAAAB4CwAA3RYAAEICAACnDQAADBkAAHEEAADWDwAA
| OxsAAKAGAAAFEgAAah0AAM8IAAA0FAAAmR8AAP4KAABjFgAAyAEAAC0NAACSGAAA9wMAAFwPAADBGgAAJgYAAIsRAADwHAAA
| VQgAALoTAAAfHwAAhAoAAOkVAABOAQAAswwAABgYAAB9AwAA4g4AAEcaAACsBQAAEREAAHYcAADbBwAAQBMAAKUeAAAKCgAA
| bxUAANQAAAA5DAAAnhcAAAMDAABoDgAAzRkAADIFAACXEAAA/BsAAGEHAADGEgAAKx4AAJAJAAD1FAAAWgAAAL8LAAAkFwAA
| iQIAAO4NAABTGQAAuAQAAB0QAACCGwAA5wYAAEwSAACxHQAAFgkAAHsUAADgHwAARQsAAKoWAAAPAgAAdA0AANkYAAA+BAAA
| ow8AAAgbAABtBgAA0hEAADcdAACcCAAAARQAAGYfAADLCgAAMBYAAJUBAAD6DAAAXxgAAMQDAAApDwAAjhoAAPMFAABYEQAA
| vRwAACIIAACHEwAA7B4AAFEKAAC2FQAAGwEAAIAMAADlFwAASgMAAK8OAAAUGgAAeQUAAN4QAABDHAAAqAcAAA0TAAByHgAA
| 1wkAADwVAAChAAAABgwAAGsXAADQAgAANQ4AAJoZAAD/BAAAZBAAAMkbAAAuBwAAkxIAAPgdAABdCQAAwhQAACcAAACMCwAA
| 8RYAAFYCAAC7DQAAIBkAAIUEAADqDwAAlAcAAPkSAABeHgAAwwkAACgVAACNAAAA8gsAAFcXAAC8AgAAIQ4AAIYZAADrBAAA
| UBAAALUbAAAaBwAAfxIAAOQdAABJCQAArhQAABMAAAB4CwAA3RYAAEICAACnDQAADBkAAHEEAADWDwAAOxsAAKAGAAAFEgAA
| ah0AAM8IAAA0FAAAmR8AAP4KAABjFgAAyAEAAC0NAACSGAAA9wMAAFwPAADBGgAAJgYAAIsRAADwHAAAVQgAALoTAAAfHwAA
| hAoAAOkVAABOAQAAswwAABgYAAB9AwAA4g4AAEcaAACsBQAAEREAAHYcAADbBwAAQBMAAKUeAAAKCgAAbxUAANQAAAA5DAAA
| nhcAAAMDAABoDgAAzRkAADIFAACXEAAA/BsAAGEHAADGEgAAKx4AAJAJAAD1FAAAWgAAAL8LAAAkFwAAiQIAAO4NAABTGQAA
| uAQAAB0QAACCGwAA5wYAAEwSAACxHQAAFgkAAHsUAADgHwAARQsAAKoWAAAPAgAAdA0AANkYAAA+BAAAow8AAAgbAABtBgAA
| 0hEAADcdAACcCAAAARQAAGYfAADLCgAAMBYAAJUBAAD6DAAAXxgAAMQDAAApDwAAjhoAAPMFAABYEQAAvRwAACIIAACHEwAA
| 7B4AAFEKAAC2FQAAGwEAAIAMAADlFwAASgMAAK8OAAAUGgAAeQUAAN4QAABDHAAAqAcAAA0TAAByHgAA1wkAADwVAAChAAAA
| BgwAAGsXAADQAgAANQ4AAJoZAAD/BAAAZBAAAMkbAAAuBwAAkxIAAPgdAABdCQAAwhQAACcAAACMCwAA8RYAAFYCAAC7DQAA
| IBkAAIUEAADqDwAATxsAALQGAAAZEgAAfh0AAOMIAABIFAAArR8AABILAAB3FgAA3AEAAEENAACmGAAACwQAAHAPAADVGgAA
| OgYAAJ8RAAAEHQAAaQgAAM4TAAAzHwAAmAoAAP0VAABiAQAAxwwAACwYAACRAwAA9g4AAFsaAADABQAAJREAAIocAADvBwAA
| VBMAALkeAAAeCgAAgxUAAOgAAABNDAAAshcAABcDAAB8DgAA4RkAAEYFAACrEAAAEBwAAHUHAADaEgAAPx4AAKQJAAAJFQAA
| bgAAANMLAAA4FwAAnQIAAAIOAABnGQAAzAQAADEQAACWGwAA+wYAAGASAADFHQAAKgkAAI8UAAD0HwAAWQsAAL4WAAAjAgAA
| iA0AAO0YAABSBAAAtw8AABwbAACBBgAA5hEAAEsdAACwCAAAFRQAAHofAADfCgAARBYAAKkBAAAODQAAcxgAANgDAAA9DwAA
| ohoAAAcGAABsEQAA0RwAADYIAACbEwAAAB8AAGUKAADKFQAALwEAANkYAAA+BAAAow8AAAgbAABtBgAA0hEAADcdAACcCAAA
| ARQAAGYfAADLCgAAMBYAAJUBAAD6DAAAXxgAAMQDAAApDwAAjhoAAPMFAABYEQAAvRwAACIIAACHEwAA7B4AAFEKAAC2FQAA
| GwEAAIAMAADlFwAASgMAAK8OAAAUGgAAeQUAAN4QAABDHAAAqAcAAA0TAAByHgAA1wkAADwVAAChAAAABgwAAGsXAADQAgAA
| NQ4AAJoZAAD/BAAAZBAAAMkbAAAuBwAAkxIAAPgdAABdCQAAwhQAACcAAACMCwAA8RYAAFYCAAC7DQAAIBkAAIUEAADqDwAA
| TxsAALQGAAAZEgAAfh0AAOMIAABIFAAArR8AABILAAB3FgAA3AEAAEENAACmGAAACwQAAHAPAADVGgAAOgYAAJ8RAAAEHQAA
| aQgAAM4TAAAzHwAAmAoAAP0VAABiAQAAxwwAACwYAACRAwAA9g4AAFsaAADABQAAJREAAIocAADvBwAAVBMAALkeAAAeCgAA
| gxUAAOgAAABNDAAAshcAABcDAAB8DgAA4RkAAEYFAACrEAAAEBwAAHUHAADaEgAAPx4AAKQJAAAJFQAAbgAAANMLAAA4FwAA
| nQIAAAIOAABnGQAAzAQAADEQAACWGwAA+wYAAGASAADFHQAAKgkAAI8UAAD0HwAAWQsAAL4WAAAjAgAAiA0AAO0YAABSBAAA
| tw8AABwbAACBBgAA5hEAAEsdAACwCAAAFRQAAHofAADfCgAARBYAAKkBAAAODQAAcxgAANgDAAA9DwAAohoAAAcGAABsEQAA
| 0RwAADYIAACbEwAAAB8AAGUKAADKFQAALwEAAJQMAAD5FwAAXgMAAMMOAAAoGgAAjQUAAPIQAABXHAAAvAcAACETAACGHgAA
| 6wkAAFAVAAC1AAAAGgwAAH8XAADkAgAASQ4AAK4ZAAATBQAAeBAAAN0bAABCBwAApxIAAAweAABxCQAA1hQAADsAAACgCwAA
| BRcAAGoCAADPDQAANBkAAJkEAAD+DwAAYxsAAMgGAAAtEgAAkh0AAPcIAABcFAAAwR8AACYLAACLFgAA8AEAAFUNAAC6GAAA
| HwQAAIQPAADpGgAATgYAALMRAAAYHQAAfQgAAOITAABHHwAArAoAABEWAAB2AQAA2wwAAEAYAAClAwAACg8AAG8aAADUBQAA
| OREAAJ4cAAADCAAAaBMAAM0eAAAyCgAAlxUAAPwAAABhDAAAxhcAACsDAACQDgAA9RkAAFoFAAC/EAAAJBwAAIkHAADuEgAA
| Ux4AALgJAAAdFQAAggAAAOcLAABMFwAAsQIAABYOAAB7GQAA4AQAAEUQAACqGwAADwcAAHQSAAAeCgAAgxUAAOgAAABNDAAA
| shcAABcDAAB8DgAA4RkAAEYFAACrEAAAEBwAAHUHAADaEgAAPx4AAKQJAAAJFQAAbgAAANMLAAA4FwAAnQIAAAIOAABnGQAA
| zAQAADEQAACWGwAA+wYAAGASAADFHQAAKgkAAI8UAAD0HwAAWQsAAL4WAAAjAgAAiA0AAO0YAABSBAAAtw8AABwbAACBBgAA
| 5hEAAEsdAACwCAAAFRQAAHofAADfCgAARBYAAKkBAAAODQAAcxgAANgDAAA9DwAAohoAAAcGAABsEQAA0RwAADYIAACbEwAA
| AB8AAGUKAADKFQAALwEAAJQMAAD5FwAAXgMAAMMOAAAoGgAAjQUAAPIQAABXHAAAvAcAACETAACGHgAA6wkAAFAVAAC1AAAA
| GgwAAH8XAADkAgAASQ4AAK4ZAAATBQAAeBAAAN0bAABCBwAApxIAAAweAABxCQAA1hQAADsAAACgCwAABRcAAGoCAADPDQAA
| NBkAAJkEAAD+DwAAYxsAAMgGAAAtEgAAkh0AAPcIAABcFAAAwR8AACYLAACLFgAA8AEAAFUNAAC6GAAAHwQAAIQPAADpGgAA
| TgYAALMRAAAYHQAAfQgAAOITAABHHwAArAoAABEWAAB2AQAA2wwAAEAYAAClAwAACg8AAG8aAADUBQAAOREAAJ4cAAADCAAA
| aBMAAM0eAAAyCgAAlxUAAPwAAABhDAAAxhcAACsDAACQDgAA9RkAAFoFAAC/EAAAJBwAAIkHAADuEgAAUx4AALgJAAAdFQAA
| ggAAAOcLAABMFwAAsQIAABYOAAB7GQAA4AQAAEUQAACqGwAADwcAAHQSAADZHQAAPgkAAKMUAAAIAAAAbQsAANIWAAA3AgAA
| nA0AAAEZAABmBAAAyw8AADAbAACVBgAA+hEAAF8dAADECAAAKRQAAI4fAADzCgAAWBYAAL0BAAAiDQAAhxgAAOwDAABRDwAA
| thoAABsGAACAEQAA5RwAAEoIAACvEwAAFB8AAHkKAADeFQAAQwEAAKgMAAANGAAAcgMAANcOAAA8GgAAoQUAAAYRAABrHAAA
| 0AcAADUTAACaHgAA/wkAAGQVAADJAAAALgwAAJMXAAD4AgAAXQ4AAMIZAAAnBQAAjBAAAPEbAABWBwAAuxIAACAeAACFCQAA
| 6hQAAE8AAAC0CwAAGRcAAH4CAADjDQAASBkAAK0EAAASEAAAdxsAANwGAABBEgAAph0AAAsJAABwFAAA1R8AADoLAACfFgAA
| BAIAAGkNAADOGAAAMwQAAJgPAAD9GgAAYgYAAMcRAAAsHQAAkQgAAPYTAABbHwAAwAoAACUWAACKAQAA7wwAAFQYAAC5AwAA
| YxsAAMgGAAAtEgAAkh0AAPcIAABcFAAAwR8AACYLAACLFgAA8AEAAFUNAAC6GAAAHwQAAIQPAADpGgAATgYAALMRAAAYHQAA
| fQgAAOITAABHHwAArAoAABEWAAB2AQAA2wwAAEAYAAClAwAACg8AAG8aAADUBQAAOREAAJ4cAAADCAAAaBMAAM0eAAAyCgAA
| lxUAAPwAAABhDAAAxhcAACsDAACQDgAA9RkAAFoFAAC/EAAAJBwAAIkHAADuEgAAUx4AALgJAAAdFQAAggAAAOcLAABMFwAA
| sQIAABYOAAB7GQAA4AQAAEUQAACqGwAADwcAAHQSAADZHQAAPgkAAKMUAAAIAAAAbQsAANIWAAA3AgAAnA0AAAEZAABmBAAA
| yw8AADAbAACVBgAA+hEAAF8dAADECAAAKRQAAI4fAADzCgAAWBYAAL0BAAAiDQAAhxgAAOwDAABRDwAAthoAABsGAACAEQAA
| 5RwAAEoIAACvEwAAFB8AAHkKAADeFQAAQwEAAKgMAAANGAAAcgMAANcOAAA8GgAAoQUAAAYRAABrHAAA0AcAADUTAACaHgAA
| /wkAAGQVAADJAAAALgwAAJMXAAD4AgAAXQ4AAMIZAAAnBQAAjBAAAPEbAABWBwAAuxIAACAeAACFCQAA6hQAAE8AAAC0CwAA
| GRcAAH4CAADjDQAASBkAAK0EAAASEAAAdxsAANwGAABBEgAAph0AAAsJAABwFAAA1R8AADoLAACfFgAABAIAAGkNAADOGAAA
| MwQAAJgPAAD9GgAAYgYAAMcRAAAsHQAAkQgAAPYTAABbHwAAwAoAACUWAACKAQAA7wwAAFQYAAC5AwAAHg8AAIMaAADoBQAA
| TREAALIcAAAXCAAAfBMAAOEeAABGCgAAqxUAABABAAB1DAAA2hcAAD8DAACkDgAACRoAAG4FAADTEAAAOBwAAJ0HAAACEwAA
| Zx4AAMwJAAAxFQAAlgAAAPsLAABgFwAAxQIAACoOAACPGQAA9AQAAFkQAAC+GwAAIwcAAIgSAADtHQAAUgkAALcUAAAcAAAA
| gQsAAOYWAABLAgAAsA0AABUZAAB6BAAA3w8AAEQbAACpBgAADhIAAHMdAADYCAAAPRQAAKIfAAAHCwAAbBYAANEBAAA2DQAA
| mxgAAAAEAABlDwAAyhoAAC8GAACUEQAA+RwAAF4IAADDEwAAKB8AAI0KAADyFQAAVwEAALwMAAAhGAAAhgMAAOsOAABQGgAA
| tQUAABoRAAB/HAAA5AcAAEkTAACuHgAAEwoAAHgVAADdAAAAQgwAAKcXAAAMAwAAcQ4AANYZAAA7BQAAoBAAAAUcAABqBwAA
| zxIAADQeAACZCQAA/hQAAKgMAAANGAAAcgMAANcOAAA8GgAAoQUAAAYRAABrHAAA0AcAADUTAACaHgAA/wkAAGQVAADJAAAA
| LgwAAJMXAAD4AgAAXQ4AAMIZAAAnBQAAjBAAAPEbAABWBwAAuxIAACAeAACFCQAA6hQAAE8AAAC0CwAAGRcAAH4CAADjDQAA
| SBkAAK0EAAASEAAAdxsAANwGAABBEgAAph0AAAsJAABwFAAA1R8AADoLAACfFgAABAIAAGkNAADOGAAAMwQAAJgPAAD9GgAA
| YgYAAMcRAAAsHQAAkQgAAPYTAABbHwAAwAoAACUWAACKAQAA7wwAAFQYAAC5AwAAHg8AAIMaAADoBQAATREAALIcAAAXCAAA
| fBMAAOEeAABGCgAAqxUAABABAAB1DAAA2hcAAD8DAACkDgAACRoAAG4FAADTEAAAOBwAAJ0HAAACEwAAZx4AAMwJAAAxFQAA
| lgAAAPsLAABgFwAAxQIAACoOAACPGQAA9AQAAFkQAAC+GwAAIwcAAIgSAADtHQAAUgkAALcUAAAcAAAAgQsAAOYWAABLAgAA
| sA0AABUZAAB6BAAA3w8AAEQbAACpBgAADhIAAHMdAADYCAAAPRQAAKIfAAAHCwAAbBYAANEBAAA2DQAAmxgAAAAEAABlDwAA
| yhoAAC8GAACUEQAA+RwAAF4IAADDEwAAKB8AAI0KAADyFQAAVwEAALwMAAAhGAAAhgMAAOsOAABQGgAAtQUAABoRAAB/HAAA
| 5AcAAEkTAACuHgAAEwoAAHgVAADdAAAAQgwAAKcXAAAMAwAAcQ4AANYZAAA7BQAAoBAAAAUcAABqBwAAzxIAADQeAACZCQAA
| /hQAAGMAAADICwAALRcAAJICAAD3DQAAXBkAAMEEAAAmEAAAixsAAPAGAABVEgAAuh0AAB8JAACEFAAA6R8AAE4LAACzFgAA
| GAIAAH0NAADiGAAARwQAAKwPAAARGwAAdgYAANsRAABAHQAApQgAAAoUAABvHwAA1AoAADkWAACeAQAAAw0AAGgYAADNAwAA
| Mg8AAJcaAAD8BQAAYREAAMYcAAArCAAAkBMAAPUeAABaCgAAvxUAACQBAACJDAAA7hcAAFMDAAC4DgAAHRoAAIIFAADnEAAA
| TBwAALEHAAAWEwAAex4AAOAJAABFFQAAqgAAAA8MAAB0FwAA2QIAAD4OAACjGQAACAUAAG0QAADSGwAANwcAAJwSAAABHgAA
| ZgkAAMsUAAAwAAAAlQsAAPoWAABfAgAAxA0AACkZAACOBAAA8w8AAFgbAAC9BgAAIhIAAIcdAADsCAAAURQAALYfAAAbCwAA
| gBYAAOUBAABKDQAArxgAABQEAAB5DwAA3hoAAEMGAADtHQAAUgkAALcUAAAcAAAAgQsAAOYWAABLAgAAsA0AABUZAAB6BAAA
| 3w8AAEQbAACpBgAADhIAAHMdAADYCAAAPRQAAKIfAAAHCwAAbBYAANEBAAA2DQAAmxgAAAAEAABlDwAAyhoAAC8GAACUEQAA
| +RwAAF4IAADDEwAAKB8AAI0KAADyFQAAVwEAALwMAAAhGAAAhgMAAOsOAABQGgAAtQUAABoRAAB/HAAA5AcAAEkTAACuHgAA
| EwoAAHgVAADdAAAAQgwAAKcXAAAMAwAAcQ4AANYZAAA7BQAAoBAAAAUcAABqBwAAzxIAADQeAACZCQAA/hQAAGMAAADICwAA
| LRcAAJICAAD3DQAAXBkAAMEEAAAmEAAAixsAAPAGAABVEgAAuh0AAB8JAACEFAAA6R8AAE4LAACzFgAAGAIAAH0NAADiGAAA
| RwQAAKwPAAARGwAAdgYAANsRAABAHQAApQgAAAoUAABvHwAA1AoAADkWAACeAQAAAw0AAGgYAADNAwAAMg8AAJcaAAD8BQAA
| YREAAMYcAAArCAAAkBMAAPUeAABaCgAAvxUAACQBAACJDAAA7hcAAFMDAAC4DgAAHRoAAIIFAADnEAAATBwAALEHAAAWEwAA
| ex4AAOAJAABFFQAAqgAAAA8MAAB0FwAA2QIAAD4OAACjGQAACAUAAG0QAADSGwAANwcAAJwSAAABHgAAZgkAAMsUAAAwAAAA
| lQsAAPoWAABfAgAAxA0AACkZAACOBAAA8w8AAFgbAAC9BgAAIhIAAIcdAADsCAAAURQAALYfAAAbCwAAgBYAAOUBAABKDQAA
| rxgAABQEAAB5DwAA3hoAAEMGAACoEQAADR0AAHIIAADXEwAAPB8AAKEKAAAGFgAAawEAANAMAAA1GAAAmgMAAP8OAABkGgAA
| yQUAAC4RAACTHAAA+AcAAF0TAADCHgAAJwoAAIwVAADxAAAAVgwAALsXAAAgAwAAhQ4AAOoZAABPBQAAtBAAABkcAAB+BwAA
| 4xIAAEgeAACtCQAAEhUAAHcAAADcCwAAQRcAAKYCAAALDgAAcBkAANUEAAA6EAAAnxsAAAQHAABpEgAAzh0AADMJAACYFAAA
| /R8AAGILAADHFgAALAIAAJENAAD2GAAAWwQAAMAPAAAlGwAAigYAAO8RAABUHQAAuQgAAB4UAACDHwAA6AoAAE0WAACyAQAA
| Fw0AAHwYAADhAwAARg8AAKsaAAAQBgAAdREAANocAAA/CAAApBMAAAkfAABuCgAA0xUAADgBAACdDAAAAhgAAGcDAADMDgAA
| MRoAAJYFAAD7EAAAYBwAAMUHAAAqEwAAjx4AAPQJAABZFQAAvgAAACMMAACIFwAAMg8AAJcaAAD8BQAAYREAAMYcAAArCAAA
| kBMAAPUeAABaCgAAvxUAACQBAACJDAAA7hcAAFMDAAC4DgAAHRoAAIIFAADnEAAATBwAALEHAAAWEwAAex4AAOAJAABFFQAA
| qgAAAA8MAAB0FwAA2QIAAD4OAACjGQAACAUAAG0QAADSGwAANwcAAJwSAAABHgAAZgkAAMsUAAAwAAAAlQsAAPoWAABfAgAA
| xA0AACkZAACOBAAA8w8AAFgbAAC9BgAAIhIAAIcdAADsCAAAURQAALYfAAAbCwAAgBYAAOUBAABKDQAArxgAABQEAAB5DwAA
| 3hoAAEMGAACoEQAADR0AAHIIAADXEwAAPB8AAKEKAAAGFgAAawEAANAMAAA1GAAAmgMAAP8OAABkGgAAyQUAAC4RAACTHAAA
| +AcAAF0TAADCHgAAJwoAAIwVAADxAAAAVgwAALsXAAAgAwAAhQ4AAOoZAABPBQAAtBAAABkcAAB+BwAA4xIAAEgeAACtCQAA
| EhUAAHcAAADcCwAAQRcAAKYCAAALDgAAcBkAANUEAAA6EAAAnxsAAAQHAABpEgAAzh0AADMJAACYFAAA/R8AAGILAADHFgAA
| LAIAAJENAAD2GAAAWwQAAMAPAAAlGwAAigYAAO8RAABUHQAAuQgAAB4UAACDHwAA6AoAAE0WAACyAQAAFw0AAHwYAADhAwAA
| Rg8AAKsaAAAQBgAAdREAANocAAA/CAAApBMAAAkfAABuCgAA0xUAADgBAACdDAAAAhgAAGcDAADMDgAAMRoAAJYFAAD7EAAA
| YBwAAMUHAAAqEwAAjx4AAPQJAABZFQAAvgAAACMMAACIFwAA7QIAAFIOAAC3GQAAHAUAAIEQAADmGwAASwcAALASAAAVHgAA
| egkAAN8UAABEAAAAqQsAAA4XAABzAgAA2A0AAD0ZAACiBAAABxAAAGwbAADRBgAANhIAAJsdAAAACQAAZRQAAMofAAAvCwAA
| lBYAAPkBAABeDQAAwxgAACgEAACNDwAA8hoAAFcGAAC8EQAAIR0AAIYIAADrEwAAUB8AALUKAAAaFgAAfwEAAOQMAABJGAAA
| rgMAABMPAAB4GgAA3QUAAEIRAACnHAAADAgAAHETAADWHgAAOwoAAKAVAAAFAQAAagwAAM8XAAA0AwAAmQ4AAP4ZAABjBQAA
| yBAAAC0cAACSBwAA9xIAAFweAADBCQAAJhUAAIsAAADwCwAAVRcAALoCAAAfDgAAhBkAAOkEAABOEAAAsxsAABgHAAB9EgAA
| 4h0AAEcJAACsFAAAEQAAAHYLAADbFgAAQAIAAKUNAAAKGQAAbwQAANQPAAA5GwAAngYAAAMSAABoHQAAzQgAAHcAAADcCwAA
| QRcAAKYCAAALDgAAcBkAANUEAAA6EAAAnxsAAAQHAABpEgAAzh0AADMJAACYFAAA/R8AAGILAADHFgAALAIAAJENAAD2GAAA
| WwQAAMAPAAAlGwAAigYAAO8RAABUHQAAuQgAAB4UAACDHwAA6AoAAE0WAACyAQAAFw0AAHwYAADhAwAARg8AAKsaAAAQBgAA
| dREAANocAAA/CAAApBMAAAkfAABuCgAA0xUAADgBAACdDAAAAhgAAGcDAADMDgAAMRoAAJYFAAD7EAAAYBwAAMUHAAAqEwAA
| jx4AAPQJAABZFQAAvgAAACMMAACIFwAA7QIAAFIOAAC3GQAAHAUAAIEQAADmGwAASwcAALASAAAVHgAAegkAAN8UAABEAAAA
| qQsAAA4XAABzAgAA2A0AAD0ZAACiBAAABxAAAGwbAADRBgAANhIAAJsdAAAACQAAZRQAAMofAAAvCwAAlBYAAPkBAABeDQAA
| wxgAACgEAACNDwAA8hoAAFcGAAC8EQAAIR0AAIYIAADrEwAAUB8AALUKAAAaFgAAfwEAAOQMAABJGAAArgMAABMPAAB4GgAA
| 3QUAAEIRAACnHAAADAgAAHETAADWHgAAOwoAAKAVAAAFAQAAagwAAM8XAAA0AwAAmQ4AAP4ZAABjBQAAyBAAAC0cAACSBwAA
| 9xIAAFweAADBCQAAJhUAAIsAAADwCwAAVRcAALoCAAAfDgAAhBkAAOkEAABOEAAAsxsAABgHAAB9EgAA4h0AAEcJAACsFAAA
| EQAAAHYLAADbFgAAQAIAAKUNAAAKGQAAbwQAANQPAAA5GwAAngYAAAMSAABoHQAAzQgAADIUAACXHwAA/AoAAGEWAADGAQAA
| Kw0AAJAYAAD1AwAAWg8AAL8aAAAkBgAAiREAAO4cAABTCAAAuBMAAB0fAACCCgAA5xUAAEwBAACxDAAAFhgAAHsDAADgDgAA
| RRoAAKoFAAAPEQAAdBwAANkHAAA+EwAAox4AAAgKAABtFQAA0gAAADcMAACcFwAAAQMAAGYOAADLGQAAMAUAAJUQAAD6GwAA
| XwcAAMQSAAApHgAAjgkAAPMUAABYAAAAvQsAACIXAACHAgAA7A0AAFEZAAC2BAAAGxAAAIAbAADlBgAAShIAAK8dAAAUCQAA
| eRQAAN4fAABDCwAAqBYAAA0CAAByDQAA1xgAADwEAAChDwAABhsAAGsGAADQEQAANR0AAJoIAAD/EwAAZB8AAMkKAAAuFgAA
| kwEAAPgMAABdGAAAwgMAACcPAACMGgAA8QUAAFYRAAC7HAAAIAgAAIUTAADqHgAATwoAALQVAAAZAQAAfgwAAOMXAABIAwAA
| rQ4AABIaAAC8EQAAIR0AAIYIAADrEwAAUB8AALUKAAAaFgAAfwEAAOQMAABJGAAArgMAABMPAAB4GgAA3QUAAEIRAACnHAAA
| DAgAAHETAADWHgAAOwoAAKAVAAAFAQAAagwAAM8XAAA0AwAAmQ4AAP4ZAABjBQAAyBAAAC0cAACSBwAA9xIAAFweAADBCQAA
| JhUAAIsAAADwCwAAVRcAALoCAAAfDgAAhBkAAOkEAABOEAAAsxsAABgHAAB9EgAA4h0AAEcJAACsFAAAEQAAAHYLAADbFgAA
| QAIAAKUNAAAKGQAAbwQAANQPAAA5GwAAngYAAAMSAABoHQAAzQgAADIUAACXHwAA/AoAAGEWAADGAQAAKw0AAJAYAAD1AwAA
| Wg8AAL8aAAAkBgAAiREAAO4cAABTCAAAuBMAAB0fAACCCgAA5xUAAEwBAACxDAAAFhgAAHsDAADgDgAARRoAAKoFAAAPEQAA
| dBwAANkHAAA+EwAAox4AAAgKAABtFQAA0gAAADcMAACcFwAAAQMAAGYOAADLGQAAMAUAAJUQAAD6GwAAXwcAAMQSAAApHgAA
| jgkAAPMUAABYAAAAvQsAACIXAACHAgAA7A0AAFEZAAC2BAAAGxAAAIAbAADlBgAAShIAAK8dAAAUCQAAeRQAAN4fAABDCwAA
| qBYAAA0CAAByDQAA1xgAADwEAAChDwAABhsAAGsGAADQEQAANR0AAJoIAAD/EwAAZB8AAMkKAAAuFgAAkwEAAPgMAABdGAAA
| wgMAACcPAACMGgAA8QUAAFYRAAC7HAAAIAgAAIUTAADqHgAATwoAALQVAAAZAQAAfgwAAOMXAABIAwAArQ4AABIaAAB3BQAA
| 3BAAAEEcAACmBwAACxMAAHAeAADVCQAAOhUAAJ8AAAAEDAAAaRcAAM4CAAAzDgAAmBkAAP0EAABiEAAAxxsAACwHAACREgAA
| 9h0AAFsJAADAFAAAJQAAAIoLAADvFgAAVAIAALkNAAAeGQAAgwQAAOgPAABNGwAAsgYAABcSAAB8HQAA4QgAAEYUAACrHwAA
| EAsAAHUWAADaAQAAPw0AAKQYAAAJBAAAbg8AANMaAAA4BgAAnREAAAIdAABnCAAAzBMAADEfAACWCgAA+xUAAGABAADFDAAA
| KhgAAI8DAAD0DgAAWRoAAL4FAAAjEQAAiBwAAO0HAABSEwAAtx4AABwKAACBFQAA5gAAAEsMAACwFwAAFQMAAHoOAADfGQAA
| RAUAAKkQAAAOHAAAcwcAANgSAAA9HgAAogkAAAcVAABsAAAA0QsAADYXAACbAgAAAA4AAGUZAADKBAAALxAAAJQbAAD5BgAA
| XhIAAMMdAAAoCQAAjRQAAPIfAABXCwAAAQMAAGYOAADLGQAAMAUAAJUQAAD6GwAAXwcAAMQSAAApHgAAjgkAAPMUAABYAAAA
| vQsAACIXAACHAgAA7A0AAFEZAAC2BAAAGxAAAIAbAADlBgAAShIAAK8dAAAUCQAAeRQAAN4fAABDCwAAqBYAAA0CAAByDQAA
| 1xgAADwEAAChDwAABhsAAGsGAADQEQAANR0AAJoIAAD/EwAAZB8AAMkKAAAuFgAAkwEAAPgMAABdGAAAwgMAACcPAACMGgAA
| 8QUAAFYRAAC7HAAAIAgAAIUTAADqHgAATwoAALQVAAAZAQAAfgwAAOMXAABIAwAArQ4AABIaAAB3BQAA3BAAAEEcAACmBwAA
| CxMAAHAeAADVCQAAOhUAAJ8AAAAEDAAAaRcAAM4CAAAzDgAAmBkAAP0EAABiEAAAxxsAACwHAACREgAA9h0AAFsJAADAFAAA
| JQAAAIoLAADvFgAAVAIAALkNAAAeGQAAgwQAAOgPAABNGwAAsgYAABcSAAB8HQAA4QgAAEYUAACrHwAAEAsAAHUWAADaAQAA
| Pw0AAKQYAAAJBAAAbg8AANMaAAA4BgAAnREAAAIdAABnCAAAzBMAADEfAACWCgAA+xUAAGABAADFDAAAKhgAAI8DAAD0DgAA
| WRoAAL4FAAAjEQAAiBwAAO0HAABSEwAAtx4AABwKAACBFQAA5gAAAEsMAACwFwAAFQMAAHoOAADfGQAARAUAAKkQAAAOHAAA
| cwcAANgSAAA9HgAAogkAAAcVAABsAAAA0QsAADYXAACbAgAAAA4AAGUZAADKBAAALxAAAJQbAAD5BgAAXhIAAMMdAAAoCQAA
| jRQAAPIfAABXCwAAvBYAACECAACGDQAA6xgAAFAEAAC1DwAAGhsAAH8GAADkEQAASR0AAK4IAAATFAAAeB8AAN0KAABCFgAA
| pwEAAAwNAABxGAAA1gMAADsPAACgGgAABQYAAGoRAADPHAAANAgAAJkTAAD+HgAAYwoAAMgVAAAtAQAAkgwAAPcXAABcAwAA
| wQ4AACYaAACLBQAA8BAAAFUcAAC6BwAAHxMAAIQeAADpCQAAThUAALMAAAAYDAAAfRcAAOICAABHDgAArBkAABEFAAB2EAAA
| 2xsAAEAHAAClEgAACh4AAG8JAADUFAAAOQAAAJ4LAAADFwAAaAIAAM0NAAAyGQAAlwQAAPwPAABhGwAAxgYAACsSAACQHQAA
| 9QgAAFoUAAC/HwAAJAsAAIkWAADuAQAAUw0AALgYAAAdBAAAgg8AAOcaAABMBgAAsREAABYdAAB7CAAA4BMAAEUfAACqCgAA
| DxYAAHQBAADZDAAAPhgAAKMDAAAIDwAAbRoAANIFAAA3EQAAnBwAAEYUAACrHwAAEAsAAHUWAADaAQAAPw0AAKQYAAAJBAAA
| bg8AANMaAAA4BgAAnREAAAIdAABnCAAAzBMAADEfAACWCgAA+xUAAGABAADFDAAAKhgAAI8DAAD0DgAAWRoAAL4FAAAjEQAA
| iBwAAO0HAABSEwAAtx4AABwKAACBFQAA5gAAAEsMAACwFwAAFQMAAHoOAADfGQAARAUAAKkQAAAOHAAAcwcAANgSAAA9HgAA
| ogkAAAcVAABsAAAA0QsAADYXAACbAgAAAA4AAGUZAADKBAAALxAAAJQbAAD5BgAAXhIAAMMdAAAoCQAAjRQAAPIfAABXCwAA
| vBYAACECAACGDQAA6xgAAFAEAAC1DwAAGhsAAH8GAADkEQAASR0AAK4IAAATFAAAeB8AAN0KAABCFgAApwEAAAwNAABxGAAA
| 1gMAADsPAACgGgAABQYAAGoRAADPHAAANAgAAJkTAAD+HgAAYwoAAMgVAAAtAQAAkgwAAPcXAABcAwAAwQ4AACYaAACLBQAA
| 8BAAAFUcAAC6BwAAHxMAAIQeAADpCQAAThUAALMAAAAYDAAAfRcAAOICAABHDgAArBkAABEFAAB2EAAA2xsAAEAHAAClEgAA
| Ch4AAG8JAADUFAAAOQAAAJ4LAAADFwAAaAIAAM0NAAAyGQAAlwQAAPwPAABhGwAAxgYAACsSAACQHQAA9QgAAFoUAAC/HwAA
| JAsAAIkWAADuAQAAUw0AALgYAAAdBAAAgg8AAOcaAABMBgAAsREAABYdAAB7CAAA4BMAAEUfAACqCgAADxYAAHQBAADZDAAA
| PhgAAKMDAAAIDwAAbRoAANIFAAA3EQAAnBwAAAEIAABmEwAAyx4AADAKAACVFQAA+gAAAF8MAADEFwAAKQMAAI4OAADzGQAA
| WAUAAL0QAAAiHAAAhwcAAOwSAABRHgAAtgkAABsVAACAAAAA5QsAAEoXAACvAgAAFA4AAHkZAADeBAAAQxAAAKgbAAANBwAA
| chIAANcdAAA8CQAAoRQAAAYAAABrCwAA0BYAADUCAACaDQAA/xgAAGQEAADJDwAALhsAAJMGAAD4EQAAXR0AAMIIAAAnFAAA
| jB8AAPEKAABWFgAAuwEAACANAACFGAAA6gMAAE8PAAC0GgAAGQYAAH4RAADjHAAASAgAAK0TAAASHwAAdwoAANwVAABBAQAA
| pgwAAAsYAABwAwAA1Q4AADoaAACfBQAABBEAAGkcAADOBwAAMxMAAJgeAAD9CQAAYhUAAMcAAAAsDAAAkRcAAPYCAABbDgAA
| wBkAACUFAACKEAAA7xsAAFQHAAC5EgAAHh4AAIMJAADoFAAATQAAALILAAAXFwAAfAIAAOENAACLBQAA8BAAAFUcAAC6BwAA
| HxMAAIQeAADpCQAAThUAALMAAAAYDAAAfRcAAOICAABHDgAArBkAABEFAAB2EAAA2xsAAEAHAAClEgAACh4AAG8JAADUFAAA
| OQAAAJ4LAAADFwAAaAIAAM0NAAAyGQAAlwQAAPwPAABhGwAAxgYAACsSAACQHQAA9QgAAFoUAAC/HwAAJAsAAIkWAADuAQAA
| Uw0AALgYAAAdBAAAgg8AAOcaAABMBgAAsREAABYdAAB7CAAA4BMAAEUfAACqCgAADxYAAHQBAADZDAAAPhgAAKMDAAAIDwAA
| bRoAANIFAAA3EQAAnBwAAAEIAABmEwAAyx4AADAKAACVFQAA+gAAAF8MAADEFwAAKQMAAI4OAADzGQAAWAUAAL0QAAAiHAAA
| hwcAAOwSAABRHgAAtgkAABsVAACAAAAA5QsAAEoXAACvAgAAFA4AAHkZAADeBAAAQxAAAKgbAAANBwAAchIAANcdAAA8CQAA
| oRQAAAYAAABrCwAA0BYAADUCAACaDQAA/xgAAGQEAADJDwAALhsAAJMGAAD4EQAAXR0AAMIIAAAnFAAAjB8AAPEKAABWFgAA
| uwEAACANAACFGAAA6gMAAE8PAAC0GgAAGQYAAH4RAADjHAAASAgAAK0TAAASHwAAdwoAANwVAABBAQAApgwAAAsYAABwAwAA
| 1Q4AADoaAACfBQAABBEAAGkcAADOBwAAMxMAAJgeAAD9CQAAYhUAAMcAAAAsDAAAkRcAAPYCAABbDgAAwBkAACUFAACKEAAA
| 7xsAAFQHAAC5EgAAHh4AAIMJAADoFAAATQAAALILAAAXFwAAfAIAAOENAABGGQAAqwQAABAQAAB1GwAA2gYAAD8SAACkHQAA
| CQkAAG4UAADTHwAAOAsAAJ0WAAACAgAAZw0AAMwYAAAxBAAAlg8AAPsaAABgBgAAxREAACodAACPCAAA9BMAAFkfAAC+CgAA
| IxYAAIgBAADtDAAAUhgAALcDAAAcDwAAgRoAAOYFAABLEQAAsBwAABUIAAB6EwAA3x4AAEQKAACpFQAADgEAAHMMAADYFwAA
| PQMAAKIOAAAHGgAAbAUAANEQAAA2HAAAmwcAAAATAABlHgAAygkAAC8VAACUAAAA+QsAAF4XAADDAgAAKA4AAI0ZAADyBAAA
| VxAAALwbAAAhBwAAhhIAAOsdAABQCQAAtRQAABoAAAB/CwAA5BYAAEkCAACuDQAAExkAAHgEAADdDwAAQhsAAKcGAAAMEgAA
| cR0AANYIAAA7FAAAoB8AAAULAABqFgAAzwEAADQNAACZGAAA/gMAAGMPAADIGgAALQYAAJIRAAD3HAAAXAgAAMETAAAmHwAA
| 0BYAADUCAACaDQAA/xgAAGQEAADJDwAALhsAAJMGAAD4EQAAXR0AAMIIAAAnFAAAjB8AAPEKAABWFgAAuwEAACANAACFGAAA
| 6gMAAE8PAAC0GgAAGQYAAH4RAADjHAAASAgAAK0TAAASHwAAdwoAANwVAABBAQAApgwAAAsYAABwAwAA1Q4AADoaAACfBQAA
| BBEAAGkcAADOBwAAMxMAAJgeAAD9CQAAYhUAAMcAAAAsDAAAkRcAAPYCAABbDgAAwBkAACUFAACKEAAA7xsAAFQHAAC5EgAA
| Hh4AAIMJAADoFAAATQAAALILAAAXFwAAfAIAAOENAABGGQAAqwQAABAQAAB1GwAA2gYAAD8SAACkHQAACQkAAG4UAADTHwAA
| OAsAAJ0WAAACAgAAZw0AAMwYAAAxBAAAlg8AAPsaAABgBgAAxREAACodAACPCAAA9BMAAFkfAAC+CgAAIxYAAIgBAADtDAAA
| UhgAALcDAAAcDwAAgRoAAOYFAABLEQAAsBwAABUIAAB6EwAA3x4AAEQKAACpFQAADgEAAHMMAADYFwAAPQMAAKIOAAAHGgAA
| bAUAANEQAAA2HAAAmwcAAAATAABlHgAAygkAAC8VAACUAAAA+QsAAF4XAADDAgAAKA4AAI0ZAADyBAAAVxAAALwbAAAhBwAA
| hhIAAOsdAABQCQAAtRQAABoAAAB/CwAA5BYAAEkCAACuDQAAExkAAHgEAADdDwAAQhsAAKcGAAAMEgAAcR0AANYIAAA7FAAA
| oB8AAAULAABqFgAAzwEAADQNAACZGAAA/gMAAGMPAADIGgAALQYAAJIRAAD3HAAAXAgAAMETAAAmHwAAiwoAAPAVAABVAQAA
| ugwAAB8YAACEAwAA6Q4AAE4aAACzBQAAGBEAAH0cAADiBwAARxMAAKweAAARCgAAdhUAANsAAABADAAApRcAAAoDAABvDgAA
| 1BkAADkFAACeEAAAAxwAAGgHAADNEgAAMh4AAJcJAAD8FAAAYQAAAMYLAAArFwAAkAIAAPUNAABaGQAAvwQAACQQAACJGwAA
| 7gYAAFMSAAC4HQAAHQkAAIIUAADnHwAATAsAALEWAAAWAgAAew0AAOAYAABFBAAAqg8AAA8bAAB0BgAA2REAAD4dAACjCAAA
| CBQAAG0fAADSCgAANxYAAJwBAAABDQAAZhgAAMsDAAAwDwAAlRoAAPoFAABfEQAAxBwAACkIAACOEwAA8x4AAFgKAAC9FQAA
| IgEAAIcMAADsFwAAUQMAALYOAAAbGgAAgAUAAOUQAABKHAAArwcAABQTAAB5HgAA3gkAAEMVAACoAAAADQwAAHIXAADXAgAA
| PA4AAKEZAAAGBQAAaxAAABUIAAB6EwAA3x4AAEQKAACpFQAADgEAAHMMAADYFwAAPQMAAKIOAAAHGgAAbAUAANEQAAA2HAAA
| mwcAAAATAABlHgAAygkAAC8VAACUAAAA+QsAAF4XAADDAgAAKA4AAI0ZAADyBAAAVxAAALwbAAAhBwAAhhIAAOsdAABQCQAA
| tRQAABoAAAB/CwAA5BYAAEkCAACuDQAAExkAAHgEAADdDwAAQhsAAKcGAAAMEgAAcR0AANYIAAA7FAAAoB8AAAULAABqFgAA
| zwEAADQNAACZGAAA/gMAAGMPAADIGgAALQYAAJIRAAD3HAAAXAgAAMETAAAmHwAAiwoAAPAVAABVAQAAugwAAB8YAACEAwAA
| 6Q4AAE4aAACzBQAAGBEAAH0cAADiBwAARxMAAKweAAARCgAAdhUAANsAAABADAAApRcAAAoDAABvDgAA1BkAADkFAACeEAAA
| AxwAAGgHAADNEgAAMh4AAJcJAAD8FAAAYQAAAMYLAAArFwAAkAIAAPUNAABaGQAAvwQAACQQAACJGwAA7gYAAFMSAAC4HQAA
| HQkAAIIUAADnHwAATAsAALEWAAAWAgAAew0AAOAYAABFBAAAqg8AAA8bAAB0BgAA2REAAD4dAACjCAAACBQAAG0fAADSCgAA
| NxYAAJwBAAABDQAAZhgAAMsDAAAwDwAAlRoAAPoFAABfEQAAxBwAACkIAACOEwAA8x4AAFgKAAC9FQAAIgEAAIcMAADsFwAA
| UQMAALYOAAAbGgAAgAUAAOUQAABKHAAArwcAABQTAAB5HgAA3gkAAEMVAACoAAAADQwAAHIXAADXAgAAPA4AAKEZAAAGBQAA
| axAAANAbAAA1BwAAmhIAAP8dAABkCQAAyRQAAC4AAACTCwAA+BYAAF0CAADCDQAAJxkAAIwEAADxDwAAVhsAALsGAAAgEgAA
| hR0AAOoIAABPFAAAtB8AABkLAAB+FgAA4wEAAEgNAACtGAAAEgQAAHcPAADcGgAAQQYAAKYRAAALHQAAcAgAANUTAAA6HwAA
| nwoAAAQWAABpAQAAzgwAADMYAACYAwAA/Q4AAGIaAADHBQAALBEAAJEcAAD2BwAAWxMAAMAeAAAlCgAAihUAAO8AAABUDAAA
| uRcAAB4DAACDDgAA6BkAAE0FAACyEAAAFxwAAHwHAADhEgAARh4AAKsJAAAQFQAAdQAAANoLAAA/FwAApAIAAAkOAABuGQAA
| 0wQAADgQAACdGwAAAgcAAGcSAADMHQAAMQkAAJYUAAD7HwAAYAsAAMUWAAAqAgAAjw0AAPQYAABZBAAAvg8AACMbAACIBgAA
| 7REAAFIdAAC3CAAAHBQAAIEfAADmCgAASxYAALABAABaGQAAvwQAACQQAACJGwAA7gYAAFMSAAC4HQAAHQkAAIIUAADnHwAA
| TAsAALEWAAAWAgAAew0AAOAYAABFBAAAqg8AAA8bAAB0BgAA2REAAD4dAACjCAAACBQAAG0fAADSCgAANxYAAJwBAAABDQAA
| ZhgAAMsDAAAwDwAAlRoAAPoFAABfEQAAxBwAACkIAACOEwAA8x4AAFgKAAC9FQAAIgEAAIcMAADsFwAAUQMAALYOAAAbGgAA
| gAUAAOUQAABKHAAArwcAABQTAAB5HgAA3gkAAEMVAACoAAAADQwAAHIXAADXAgAAPA4AAKEZAAAGBQAAaxAAANAbAAA1BwAA
| mhIAAP8dAABkCQAAyRQAAC4AAACTCwAA+BYAAF0CAADCDQAAJxkAAIwEAADxDwAAVhsAALsGAAAgEgAAhR0AAOoIAABPFAAA
| tB8AABkLAAB+FgAA4wEAAEgNAACtGAAAEgQAAHcPAADcGgAAQQYAAKYRAAALHQAAcAgAANUTAAA6HwAAnwoAAAQWAABpAQAA
| zgwAADMYAACYAwAA/Q4AAGIaAADHBQAALBEAAJEcAAD2BwAAWxMAAMAeAAAlCgAAihUAAO8AAABUDAAAuRcAAB4DAACDDgAA
| 6BkAAE0FAACyEAAAFxwAAHwHAADhEgAARh4AAKsJAAAQFQAAdQAAANoLAAA/FwAApAIAAAkOAABuGQAA0wQAADgQAACdGwAA
| AgcAAGcSAADMHQAAMQkAAJYUAAD7HwAAYAsAAMUWAAAqAgAAjw0AAPQYAABZBAAAvg8AACMbAACIBgAA7REAAFIdAAC3CAAA
| HBQAAIEfAADmCgAASxYAALABAAAVDQAAehgAAN8DAABEDwAAqRoAAA4GAABzEQAA2BwAAD0IAACiEwAABx8AAGwKAADRFQAA
| NgEAAJsMAAAAGAAAZQMAAMoOAAAvGgAAlAUAAPkQAABeHAAAwwcAACgTAACNHgAA8gkAAFcVAAC8AAAAIQwAAIYXAADrAgAA
| UA4AALUZAAAaBQAAfxAAAOQbAABJBwAArhIAABMeAAB4CQAA3RQAAEIAAACnCwAADBcAAHECAADWDQAAOxkAAKAEAAAFEAAA
| ahsAAM8GAAA0EgAAmR0AAP4IAABjFAAAyB8AAC0LAACSFgAA9wEAAFwNAADBGAAAJgQAAIsPAADwGgAAVQYAALoRAAAfHQAA
| hAgAAOkTAABOHwAAswoAABgWAAB9AQAA4gwAAEcYAACsAwAAEQ8AAHYaAADbBQAAQBEAAKUcAAAKCAAAbxMAANQeAAA5CgAA
| nhUAAAMBAABoDAAAzRcAADIDAACXDgAA/BkAAGEFAADGEAAAKxwAAJAHAAD1EgAAnwoAAAQWAABpAQAAzgwAADMYAACYAwAA
| /Q4AAGIaAADHBQAALBEAAJEcAAD2BwAAWxMAAMAeAAAlCgAAihUAAO8AAABUDAAAuRcAAB4DAACDDgAA6BkAAE0FAACyEAAA
| FxwAAHwHAADhEgAARh4AAKsJAAAQFQAAdQAAANoLAAA/FwAApAIAAAkOAABuGQAA0wQAADgQAACdGwAAAgcAAGcSAADMHQAA
| MQkAAJYUAAD7HwAAYAsAAMUWAAAqAgAAjw0AAPQYAABZBAAAvg8AACMbAACIBgAA7REAAFIdAAC3CAAAHBQAAIEfAADmCgAA
| SxYAALABAAAVDQAAehgAAN8DAABEDwAAqRoAAA4GAABzEQAA2BwAAD0IAACiEwAABx8AAGwKAADRFQAANgEAAJsMAAAAGAAA
| ZQMAAMoOAAAvGgAAlAUAAPkQAABeHAAAwwcAACgTAACNHgAA8gkAAFcVAAC8AAAAIQwAAIYXAADrAgAAUA4AALUZAAAaBQAA
| fxAAAOQbAABJBwAArhIAABMeAAB4CQAA3RQAAEIAAACnCwAADBcAAHECAADWDQAAOxkAAKAEAAAFEAAAahsAAM8GAAA0EgAA
| mR0AAP4IAABjFAAAyB8AAC0LAACSFgAA9wEAAFwNAADBGAAAJgQAAIsPAADwGgAAVQYAALoRAAAfHQAAhAgAAOkTAABOHwAA
| swoAABgWAAB9AQAA4gwAAEcYAACsAwAAEQ8AAHYaAADbBQAAQBEAAKUcAAAKCAAAbxMAANQeAAA5CgAAnhUAAAMBAABoDAAA
| zRcAADIDAACXDgAA/BkAAGEFAADGEAAAKxwAAJAHAAD1EgAAWh4AAL8JAAAkFQAAiQAAAO4LAABTFwAAuAIAAB0OAACCGQAA
| 5wQAAEwQAACxGwAAFgcAAHsSAADgHQAARQkAAKoUAAAPAAAAdAsAANkWAAA+AgAAow0AAAgZAABtBAAA0g8AADcbAACcBgAA
| ARIAAGYdAADLCAAAMBQAAJUfAAD6CgAAXxYAAMQBAAApDQAAjhgAAPMDAABYDwAAvRoAACIGAACHEQAA7BwAAFEIAAC2EwAA
| Gx8AAIAKAADlFQAASgEAAK8MAAAUGAAAeQMAAN4OAABDGgAAqAUAAA0RAAByHAAA1wcAADwTAAChHgAABgoAAGsVAADQAAAA
| NQwAAJoXAAD/AgAAZA4AAMkZAAAuBQAAkxAAAPgbAABdBwAAwhIAACceAACMCQAA8RQAAFYAAAC7CwAAIBcAAIUCAADqDQAA
| TxkAALQEAAAZEAAAfhsAAOMGAABIEgAArR0AABIJAAB3FAAA3B8AAEELAACmFgAACwIAAHANAADVGAAAOgQAAOQbAABJBwAA
| rhIAABMeAAB4CQAA3RQAAEIAAACnCwAADBcAAHECAADWDQAAOxkAAKAEAAAFEAAAahsAAM8GAAA0EgAAmR0AAP4IAABjFAAA
| yB8AAC0LAACSFgAA9wEAAFwNAADBGAAAJgQAAIsPAADwGgAAVQYAALoRAAAfHQAAhAgAAOkTAABOHwAAswoAABgWAAB9AQAA
| 4gwAAEcYAACsAwAAEQ8AAHYaAADbBQAAQBEAAKUcAAAKCAAAbxMAANQeAAA5CgAAnhUAAAMBAABoDAAAzRcAADIDAACXDgAA
| /BkAAGEFAADGEAAAKxwAAJAHAAD1EgAAWh4AAL8JAAAkFQAAiQAAAO4LAABTFwAAuAIAAB0OAACCGQAA5wQAAEwQAACxGwAA
| FgcAAHsSAADgHQAARQkAAKoUAAAPAAAAdAsAANkWAAA+AgAAow0AAAgZAABtBAAA0g8AADcbAACcBgAAARIAAGYdAADLCAAA
| MBQAAJUfAAD6CgAAXxYAAMQBAAApDQAAjhgAAPMDAABYDwAAvRoAACIGAACHEQAA7BwAAFEIAAC2EwAAGx8AAIAKAADlFQAA
| SgEAAK8MAAAUGAAAeQMAAN4OAABDGgAAqAUAAA0RAAByHAAA1wcAADwTAAChHgAABgoAAGsVAADQAAAANQwAAJoXAAD/AgAA
| ZA4AAMkZAAAuBQAAkxAAAPgbAABdBwAAwhIAACceAACMCQAA8RQAAFYAAAC7CwAAIBcAAIUCAADqDQAATxkAALQEAAAZEAAA
| fhsAAOMGAABIEgAArR0AABIJAAB3FAAA3B8AAEELAACmFgAACwIAAHANAADVGAAAOgQAAJ8PAAAEGwAAaQYAAM4RAAAzHQAA
| mAgAAP0TAABiHwAAxwoAACwWAACRAQAA9gwAAFsYAADAAwAAJQ8AAIoaAADvBQAAVBEAALkcAAAeCAAAgxMAAOgeAABNCgAA
| shUAABcBAAB8DAAA4RcAAEYDAACrDgAAEBoAAHUFAADaEAAAPxwAAKQHAAAJEwAAbh4AANMJAAA4FQAAnQAAAAIMAABnFwAA
| zAIAADEOAACWGQAA+wQAAGAQAADFGwAAKgcAAI8SAAD0HQAAWQkAAL4UAAAjAAAAiAsAAO0WAABSAgAAtw0AABwZAACBBAAA
| 5g8AAEsbAACwBgAAFRIAAHodAADfCAAARBQAAKkfAAAOCwAAcxYAANgBAAA9DQAAohgAAAcEAABsDwAA0RoAADYGAACbEQAA
| AB0AAGUIAADKEwAALx8AAJQKAAD5FQAAXgEAAMMMAAAoGAAAjQMAAPIOAABXGgAAvAUAACERAACGHAAA6wcAAFATAAC1HgAA
| GgoAAH8VAAApDQAAjhgAAPMDAABYDwAAvRoAACIGAACHEQAA7BwAAFEIAAC2EwAAGx8AAIAKAADlFQAASgEAAK8MAAAUGAAA
| eQMAAN4OAABDGgAAqAUAAA0RAAByHAAA1wcAADwTAAChHgAABgoAAGsVAADQAAAANQwAAJoXAAD/AgAAZA4AAMkZAAAuBQAA
| kxAAAPgbAABdBwAAwhIAACceAACMCQAA8RQAAFYAAAC7CwAAIBcAAIUCAADqDQAATxkAALQEAAAZEAAAfhsAAOMGAABIEgAA
| rR0AABIJAAB3FAAA3B8AAEELAACmFgAACwIAAHANAADVGAAAOgQAAJ8PAAAEGwAAaQYAAM4RAAAzHQAAmAgAAP0TAABiHwAA
| xwoAACwWAACRAQAA9gwAAFsYAADAAwAAJQ8AAIoaAADvBQAAVBEAALkcAAAeCAAAgxMAAOgeAABNCgAAshUAABcBAAB8DAAA
| 4RcAAEYDAACrDgAAEBoAAHUFAADaEAAAPxwAAKQHAAAJEwAAbh4AANMJAAA4FQAAnQAAAAIMAABnFwAAzAIAADEOAACWGQAA
| +wQAAGAQAADFGwAAKgcAAI8SAAD0HQAAWQkAAL4UAAAjAAAAiAsAAO0WAABSAgAAtw0AABwZAACBBAAA5g8AAEsbAACwBgAA
| FRIAAHodAADfCAAARBQAAKkfAAAOCwAAcxYAANgBAAA9DQAAohgAAAcEAABsDwAA0RoAADYGAACbEQAAAB0AAGUIAADKEwAA
| Lx8AAJQKAAD5FQAAXgEAAMMMAAAoGAAAjQMAAPIOAABXGgAAvAUAACERAACGHAAA6wcAAFATAAC1HgAAGgoAAH8VAADkAAAA
| SQwAAK4XAAATAwAAeA4AAN0ZAABCBQAApxAAAAwcAABxBwAA1hIAADseAACgCQAABRUAAGoAAADPCwAANBcAAJkCAAD+DQAA
| YxkAAMgEAAAtEAAAkhsAAPcGAABcEgAAwR0AACYJAACLFAAA8B8AAFULAAC6FgAAHwIAAIQNAADpGAAATgQAALMPAAAYGwAA
| fQYAAOIRAABHHQAArAgAABEUAAB2HwAA2woAAEAWAAClAQAACg0AAG8YAADUAwAAOQ8AAJ4aAAADBgAAaBEAAM0cAAAyCAAA
| lxMAAPweAABhCgAAxhUAACsBAACQDAAA9RcAAFoDAAC/DgAAJBoAAIkFAADuEAAAUxwAALgHAAAdEwAAgh4AAOcJAABMFQAA
| sQAAABYMAAB7FwAA4AIAAEUOAACqGQAADwUAAHQQAADZGwAAPgcAAKMSAAAIHgAAbQkAANIUAAA3AAAAnAsAAAEXAABmAgAA
| yw0AADAZAACVBAAA+g8AAF8bAADEBgAAbh4AANMJAAA4FQAAnQAAAAIMAABnFwAAzAIAADEOAACWGQAA+wQAAGAQAADFGwAA
| KgcAAI8SAAD0HQAAWQkAAL4UAAAjAAAAiAsAAO0WAABSAgAAtw0AABwZAACBBAAA5g8AAEsbAACwBgAAFRIAAHodAADfCAAA
| RBQAAKkfAAAOCwAAcxYAANgBAAA9DQAAohgAAAcEAABsDwAA0RoAADYGAACbEQAAAB0AAGUIAADKEwAALx8AAJQKAAD5FQAA
| XgEAAMMMAAAoGAAAjQMAAPIOAABXGgAAvAUAACERAACGHAAA6wcAAFATAAC1HgAAGgoAAH8VAADkAAAASQwAAK4XAAATAwAA
| eA4AAN0ZAABCBQAApxAAAAwcAABxBwAA1hIAADseAACgCQAABRUAAGoAAADPCwAANBcAAJkCAAD+DQAAYxkAAMgEAAAtEAAA
| khsAAPcGAABcEgAAwR0AACYJAACLFAAA8B8AAFULAAC6FgAAHwIAAIQNAADpGAAATgQAALMPAAAYGwAAfQYAAOIRAABHHQAA
| rAgAABEUAAB2HwAA2woAAEAWAAClAQAACg0AAG8YAADUAwAAOQ8AAJ4aAAADBgAAaBEAAM0cAAAyCAAAlxMAAPweAABhCgAA
| xhUAACsBAACQDAAA9RcAAFoDAAC/DgAAJBoAAIkFAADuEAAAUxwAALgHAAAdEwAAgh4AAOcJAABMFQAAsQAAABYMAAB7FwAA
| 4AIAAEUOAACqGQAADwUAAHQQAADZGwAAPgcAAKMSAAAIHgAAbQkAANIUAAA3AAAAnAsAAAEXAABmAgAAyw0AADAZAACVBAAA
| +g8AAF8bAADEBgAAKRIAAI4dAADzCAAAWBQAAL0fAAAiCwAAhxYAAOwBAABRDQAAthgAABsEAACADwAA5RoAAEoGAACvEQAA
| FB0AAHkIAADeEwAAQx8AAKgKAAANFgAAcgEAANcMAAA8GAAAoQMAAAYPAABrGgAA0AUAADURAACaHAAA/wcAAGQTAADJHgAA
| LgoAAJMVAAD4AAAAXQwAAMIXAAAnAwAAjA4AAPEZAABWBQAAuxAAACAcAACFBwAA6hIAAE8eAAC0CQAAGRUAAH4AAADjCwAA
| SBcAAK0CAAASDgAAdxkAANwEAABBEAAAphsAAAsHAABwEgAA1R0AADoJAACfFAAABAAAAGkLAADOFgAAMwIAAJgNAAD9GAAA
| YgQAAMcPAAAsGwAAkQYAAPYRAABbHQAAwAgAACUUAACKHwAA7woAAFQWAAC5AQAAHg0AAIMYAADoAwAATQ8AALIaAAAXBgAA
| fBEAAOEcAABGCAAAqxMAABAfAAB1CgAA2hUAAD8BAACkDAAACRgAALMPAAAYGwAAfQYAAOIRAABHHQAArAgAABEUAAB2HwAA
| 2woAAEAWAAClAQAACg0AAG8YAADUAwAAOQ8AAJ4aAAADBgAAaBEAAM0cAAAyCAAAlxMAAPweAABhCgAAxhUAACsBAACQDAAA
| 9RcAAFoDAAC/DgAAJBoAAIkFAADuEAAAUxwAALgHAAAdEwAAgh4AAOcJAABMFQAAsQAAABYMAAB7FwAA4AIAAEUOAACqGQAA
| DwUAAHQQAADZGwAAPgcAAKMSAAAIHgAAbQkAANIUAAA3AAAAnAsAAAEXAABmAgAAyw0AADAZAACVBAAA+g8AAF8bAADEBgAA
| KRIAAI4dAADzCAAAWBQAAL0fAAAiCwAAhxYAAOwBAABRDQAAthgAABsEAACADwAA5RoAAEoGAACvEQAAFB0AAHkIAADeEwAA
| Qx8AAKgKAAANFgAAcgEAANcMAAA8GAAAoQMAAAYPAABrGgAA0AUAADURAACaHAAA/wcAAGQTAADJHgAALgoAAJMVAAD4AAAA
| XQwAAMIXAAAnAwAAjA4AAPEZAABWBQAAuxAAACAcAACFBwAA6hIAAE8eAAC0CQAAGRUAAH4AAADjCwAASBcAAK0CAAASDgAA
| dxkAANwEAABBEAAAphsAAAsHAABwEgAA1R0AADoJAACfFAAABAAAAGkLAADOFgAAMwIAAJgNAAD9GAAAYgQAAMcPAAAsGwAA
| kQYAAPYRAABbHQAAwAgAACUUAACKHwAA7woAAFQWAAC5AQAAHg0AAIMYAADoAwAATQ8AALIaAAAXBgAAfBEAAOEcAABGCAAA
| qxMAABAfAAB1CgAA2hUAAD8BAACkDAAACRgAAG4DAADTDgAAOBoAAJ0FAAACEQAAZxwAAMwHAAAxEwAAlh4AAPsJAABgFQAA
| xQAAACoMAACPFwAA9AIAAFkOAAC+GQAAIwUAAIgQAADtGwAAUgcAALcSAAAcHgAAgQkAAOYUAABLAAAAsAsAABUXAAB6AgAA
| 3w0AAEQZAACpBAAADhAAAHMbAADYBgAAPRIAAKIdAAAHCQAAbBQAANEfAAA2CwAAmxYAAAACAABlDQAAyhgAAC8EAACUDwAA
| +RoAAF4GAADDEQAAKB0AAI0IAADyEwAAVx8AALwKAAAhFgAAhgEAAOsMAABQGAAAtQMAABoPAAB/GgAA5AUAAEkRAACuHAAA
| EwgAAHgTAADdHgAAQgoAAKcVAAAMAQAAcQwAANYXAAA7AwAAoA4AAAUaAABqBQAAzxAAADQcAACZBwAA/hIAAGMeAADICQAA
| LRUAAJIAAAD3CwAAXBcAAMECAAAmDgAAixkAAPAEAABVEAAAuhsAAB8HAACEEgAA6R0AAE4JAAD4AAAAXQwAAMIXAAAnAwAA
| jA4AAPEZAABWBQAAuxAAACAcAACFBwAA6hIAAE8eAAC0CQAAGRUAAH4AAADjCwAASBcAAK0CAAASDgAAdxkAANwEAABBEAAA
| phsAAAsHAABwEgAA1R0AADoJAACfFAAABAAAAGkLAADOFgAAMwIAAJgNAAD9GAAAYgQAAMcPAAAsGwAAkQYAAPYRAABbHQAA
| wAgAACUUAACKHwAA7woAAFQWAAC5AQAAHg0AAIMYAADoAwAATQ8AALIaAAAXBgAAfBEAAOEcAABGCAAAqxMAABAfAAB1CgAA
| 2hUAAD8BAACkDAAACRgAAG4DAADTDgAAOBoAAJ0FAAACEQAAZxwAAMwHAAAxEwAAlh4AAPsJAABgFQAAxQAAACoMAACPFwAA
| 9AIAAFkOAAC+GQAAIwUAAIgQAADtGwAAUgcAALcSAAAcHgAAgQkAAOYUAABLAAAAsAsAABUXAAB6AgAA3w0AAEQZAACpBAAA
| DhAAAHMbAADYBgAAPRIAAKIdAAAHCQAAbBQAANEfAAA2CwAAmxYAAAACAABlDQAAyhgAAC8EAACUDwAA+RoAAF4GAADDEQAA
| KB0AAI0IAADyEwAAVx8AALwKAAAhFgAAhgEAAOsMAABQGAAAtQMAABoPAAB/GgAA5AUAAEkRAACuHAAAEwgAAHgTAADdHgAA
| QgoAAKcVAAAMAQAAcQwAANYXAAA7AwAAoA4AAAUaAABqBQAAzxAAADQcAACZBwAA/hIAAGMeAADICQAALRUAAJIAAAD3CwAA
| XBcAAMECAAAmDgAAixkAAPAEAABVEAAAuhsAAB8HAACEEgAA6R0AAE4JAACzFAAAGAAAAH0LAADiFgAARwIAAKwNAAARGQAA
| dgQAANsPAABAGwAApQYAAAoSAABvHQAA1AgAADkUAACeHwAAAwsAAGgWAADNAQAAMg0AAJcYAAD8AwAAYQ8AAMYaAAArBgAA
| kBEAAPUcAABaCAAAvxMAACQfAACJCgAA7hUAAFMBAAC4DAAAHRgAAIIDAADnDgAATBoAALEFAAAWEQAAexwAAOAHAABFEwAA
| qh4AAA8KAAB0FQAA2QAAAD4MAACjFwAACAMAAG0OAADSGQAANwUAAJwQAAABHAAAZgcAAMsSAAAwHgAAlQkAAPoUAABfAAAA
| xAsAACkXAACOAgAA8w0AAFgZAAC9BAAAIhAAAIcbAADsBgAAURIAALYdAAAbCQAAgBQAAOUfAABKCwAArxYAABQCAAB5DQAA
| 3hgAAEMEAACoDwAADRsAAHIGAADXEQAAPB0AAKEIAAAGFAAAax8AANAKAAA1FgAAmgEAAP8MAABkGAAAyQMAAC4PAACTGgAA
| PRIAAKIdAAAHCQAAbBQAANEfAAA2CwAAmxYAAAACAABlDQAAyhgAAC8EAACUDwAA+RoAAF4GAADDEQAAKB0AAI0IAADyEwAA
| Vx8AALwKAAAhFgAAhgEAAOsMAABQGAAAtQMAABoPAAB/GgAA5AUAAEkRAACuHAAAEwgAAHgTAADdHgAAQgoAAKcVAAAMAQAA
| cQwAANYXAAA7AwAAoA4AAAUaAABqBQAAzxAAADQcAACZBwAA/hIAAGMeAADICQAALRUAAJIAAAD3CwAAXBcAAMECAAAmDgAA
| ixkAAPAEAABVEAAAuhsAAB8HAACEEgAA6R0AAE4JAACzFAAAGAAAAH0LAADiFgAARwIAAKwNAAARGQAAdgQAANsPAABAGwAA
| pQYAAAoSAABvHQAA1AgAADkUAACeHwAAAwsAAGgWAADNAQAAMg0AAJcYAAD8AwAAYQ8AAMYaAAArBgAAkBEAAPUcAABaCAAA
| vxMAACQfAACJCgAA7hUAAFMBAAC4DAAAHRgAAIIDAADnDgAATBoAALEFAAAWEQAAexwAAOAHAABFEwAAqh4AAA8KAAB0FQAA
| 2QAAAD4MAACjFwAACAMAAG0OAADSGQAANwUAAJwQAAABHAAAZgcAAMsSAAAwHgAAlQkAAPoUAABfAAAAxAsAACkXAACOAgAA
| 8w0AAFgZAAC9BAAAIhAAAIcbAADsBgAAURIAALYdAAAbCQAAgBQAAOUfAABKCwAArxYAABQCAAB5DQAA3hgAAEMEAACoDwAA
| DRsAAHIGAADXEQAAPB0AAKEIAAAGFAAAax8AANAKAAA1FgAAmgEAAP8MAABkGAAAyQMAAC4PAACTGgAA+AUAAF0RAADCHAAA
| JwgAAIwTAADxHgAAVgoAALsVAAAgAQAAhQwAAOoXAABPAwAAtA4AABkaAAB+BQAA4xAAAEgcAACtBwAAEhMAAHceAADcCQAA
| QRUAAKYAAAALDAAAcBcAANUCAAA6DgAAnxkAAAQFAABpEAAAzhsAADMHAACYEgAA/R0AAGIJAADHFAAALAAAAJELAAD2FgAA
| WwIAAMANAAAlGQAAigQAAO8PAABUGwAAuQYAAB4SAACDHQAA6AgAAE0UAACyHwAAFwsAAHwWAADhAQAARg0AAKsYAAAQBAAA
| dQ8AANoaAAA/BgAApBEAAAkdAABuCAAA0xMAADgfAACdCgAAAhYAAGcBAADMDAAAMRgAAJYDAAD7DgAAYBoAAMUFAAAqEQAA
| jxwAAPQHAABZEwAAvh4AACMKAACIFQAA7QAAAFIMAAC3FwAAHAMAAIEOAADmGQAASwUAALAQAAAVHAAAegcAAN8SAABEHgAA
| qQkAAA4VAABzAAAA2AsAAIIDAADnDgAATBoAALEFAAAWEQAAexwAAOAHAABFEwAAqh4AAA8KAAB0FQAA2QAAAD4MAACjFwAA
| CAMAAG0OAADSGQAANwUAAJwQAAABHAAAZgcAAMsSAAAwHgAAlQkAAPoUAABfAAAAxAsAACkXAACOAgAA8w0AAFgZAAC9BAAA
| IhAAAIcbAADsBgAAURIAALYdAAAbCQAAgBQAAOUfAABKCwAArxYAABQCAAB5DQAA3hgAAEMEAACoDwAADRsAAHIGAADXEQAA
| PB0AAKEIAAAGFAAAax8AANAKAAA1FgAAmgEAAP8MAABkGAAAyQMAAC4PAACTGgAA+AUAAF0RAADCHAAAJwgAAIwTAADxHgAA
| VgoAALsVAAAgAQAAhQwAAOoXAABPAwAAtA4AABkaAAB+BQAA4xAAAEgcAACtBwAAEhMAAHceAADcCQAAQRUAAKYAAAALDAAA
| cBcAANUCAAA6DgAAnxkAAAQFAABpEAAAzhsAADMHAACYEgAA/R0AAGIJAADHFAAALAAAAJELAAD2FgAAWwIAAMANAAAlGQAA
| igQAAO8PAABUGwAAuQYAAB4SAACDHQAA6AgAAE0UAACyHwAAFwsAAHwWAADhAQAARg0AAKsYAAAQBAAAdQ8AANoaAAA/BgAA
| pBEAAAkdAABuCAAA0xMAADgfAACdCgAAAhYAAGcBAADMDAAAMRgAAJYDAAD7DgAAYBoAAMUFAAAqEQAAjxwAAPQHAABZEwAA
| vh4AACMKAACIFQAA7QAAAFIMAAC3FwAAHAMAAIEOAADmGQAASwUAALAQAAAVHAAAegcAAN8SAABEHgAAqQkAAA4VAABzAAAA
| 2AsAAD0XAACiAgAABw4AAGwZAADRBAAANhAAAJsbAAAABwAAZRIAAModAAAvCQAAlBQAAPkfAABeCwAAwxYAACgCAACNDQAA
| 8hgAAFcEAAC8DwAAIRsAAIYGAADrEQAAUB0AALUIAAAaFAAAfx8AAOQKAABJFgAArgEAABMNAAB4GAAA3QMAAEIPAACnGgAA
| DAYAAHERAADWHAAAOwgAAKATAAAFHwAAagoAAM8VAAA0AQAAmQwAAP4XAABjAwAAyA4AAC0aAACSBQAA9xAAAFwcAADBBwAA
| JhMAAIseAADwCQAAVRUAALoAAAAfDAAAhBcAAOkCAABODgAAsxkAABgFAAB9EAAA4hsAAEcHAACsEgAAER4AAHYJAADbFAAA
| QAAAAKULAAAKFwAAbwIAANQNAAA5GQAAngQAAAMQAABoGwAAzQYAADISAACXHQAA/AgAAGEUAADGHwAAKwsAAJAWAAD1AQAA
| Wg0AAL8YAAAkBAAAiQ8AAO4aAABTBgAAuBEAAB0dAADHFAAALAAAAJELAAD2FgAAWwIAAMANAAAlGQAAigQAAO8PAABUGwAA
| uQYAAB4SAACDHQAA6AgAAE0UAACyHwAAFwsAAHwWAADhAQAARg0AAKsYAAAQBAAAdQ8AANoaAAA/BgAApBEAAAkdAABuCAAA
| 0xMAADgfAACdCgAAAhYAAGcBAADMDAAAMRgAAJYDAAD7DgAAYBoAAMUFAAAqEQAAjxwAAPQHAABZEwAAvh4AACMKAACIFQAA
| 7QAAAFIMAAC3FwAAHAMAAIEOAADmGQAASwUAALAQAAAVHAAAegcAAN8SAABEHgAAqQkAAA4VAABzAAAA2AsAAD0XAACiAgAA
| Bw4AAGwZAADRBAAANhAAAJsbAAAABwAAZRIAAModAAAvCQAAlBQAAPkfAABeCwAAwxYAACgCAACNDQAA8hgAAFcEAAC8DwAA
| IRsAAIYGAADrEQAAUB0AALUIAAAaFAAAfx8AAOQKAABJFgAArgEAABMNAAB4GAAA3QMAAEIPAACnGgAADAYAAHERAADWHAAA
| OwgAAKATAAAFHwAAagoAAM8VAAA0AQAAmQwAAP4XAABjAwAAyA4AAC0aAACSBQAA9xAAAFwcAADBBwAAJhMAAIseAADwCQAA
| VRUAALoAAAAfDAAAhBcAAOkCAABODgAAsxkAABgFAAB9EAAA4hsAAEcHAACsEgAAER4AAHYJAADbFAAAQAAAAKULAAAKFwAA
| bwIAANQNAAA5GQAAngQAAAMQAABoGwAAzQYAADISAACXHQAA/AgAAGEUAADGHwAAKwsAAJAWAAD1AQAAWg0AAL8YAAAkBAAA
| iQ8AAO4aAABTBgAAuBEAAB0dAACCCAAA5xMAAEwfAACxCgAAFhYAAHsBAADgDAAARRgAAKoDAAAPDwAAdBoAANkFAAA+EQAA
| oxwAAAgIAABtEwAA0h4AADcKAACcFQAAAQEAAGYMAADLFwAAMAMAAJUOAAD6GQAAXwUAAMQQAAApHAAAjgcAAPMSAABYHgAA
| vQkAACIVAACHAAAA7AsAAFEXAAC2AgAAGw4AAIAZAADlBAAAShAAAK8bAAAUBwAAeRIAAN4dAABDCQAAqBQAAA0AAAByCwAA
| 1xYAADwCAAChDQAABhkAAGsEAADQDwAANRsAAJoGAAD/EQAAZB0AAMkIAAAuFAAAkx8AAPgKAABdFgAAwgEAACcNAACMGAAA
| 8QMAAFYPAAC7GgAAIAYAAIURAADqHAAATwgAALQTAAAZHwAAfgoAAOMVAABIAQAArQwAABIYAAB3AwAA3A4AAEEaAACmBQAA
| CxEAAHAcAADVBwAAOhMAAJ8eAAAECgAAaRUAAM4AAAAzDAAAmBcAAP0CAABiDgAADAYAAHERAADWHAAAOwgAAKATAAAFHwAA
| agoAAM8VAAA0AQAAmQwAAP4XAABjAwAAyA4AAC0aAACSBQAA9xAAAFwcAADBBwAAJhMAAIseAADwCQAAVRUAALoAAAAfDAAA
| hBcAAOkCAABODgAAsxkAABgFAAB9EAAA4hsAAEcHAACsEgAAER4AAHYJAADbFAAAQAAAAKULAAAKFwAAbwIAANQNAAA5GQAA
| ngQAAAMQAABoGwAAzQYAADISAACXHQAA/AgAAGEUAADGHwAAKwsAAJAWAAD1AQAAWg0AAL8YAAAkBAAAiQ8AAO4aAABTBgAA
| uBEAAB0dAACCCAAA5xMAAEwfAACxCgAAFhYAAHsBAADgDAAARRgAAKoDAAAPDwAAdBoAANkFAAA+EQAAoxwAAAgIAABtEwAA
| 0h4AADcKAACcFQAAAQEAAGYMAADLFwAAMAMAAJUOAAD6GQAAXwUAAMQQAAApHAAAjgcAAPMSAABYHgAAvQkAACIVAACHAAAA
| 7AsAAFEXAAC2AgAAGw4AAIAZAADlBAAAShAAAK8bAAAUBwAAeRIAAN4dAABDCQAAqBQAAA0AAAByCwAA1xYAADwCAAChDQAA
| BhkAAGsEAADQDwAANRsAAJoGAAD/EQAAZB0AAMkIAAAuFAAAkx8AAPgKAABdFgAAwgEAACcNAACMGAAA8QMAAFYPAAC7GgAA
| IAYAAIURAADqHAAATwgAALQTAAAZHwAAfgoAAOMVAABIAQAArQwAABIYAAB3AwAA3A4AAEEaAACmBQAACxEAAHAcAADVBwAA
| OhMAAJ8eAAAECgAAaRUAAM4AAAAzDAAAmBcAAP0CAABiDgAAxxkAACwFAACREAAA9hsAAFsHAADAEgAAJR4AAIoJAADvFAAA
| VAAAALkLAAAeFwAAgwIAAOgNAABNGQAAsgQAABcQAAB8GwAA4QYAAEYSAACrHQAAEAkAAHUUAADaHwAAPwsAAKQWAAAJAgAA
| bg0AANMYAAA4BAAAnQ8AAAIbAABnBgAAzBEAADEdAACWCAAA+xMAAGAfAADFCgAAKhYAAI8BAAD0DAAAWRgAAL4DAAAjDwAA
| iBoAAO0FAABSEQAAtxwAABwIAACBEwAA5h4AAEsKAACwFQAAFQEAAHoMAADfFwAARAMAAKkOAAAOGgAAcwUAANgQAAA9HAAA
| ogcAAAcTAABsHgAA0QkAADYVAACbAAAAAAwAAGUXAADKAgAALw4AAJQZAAD5BAAAXhAAAMMbAAAoBwAAjRIAAPIdAABXCQAA
| vBQAACEAAACGCwAA6xYAAFACAAC1DQAAGhkAAH8EAADkDwAASRsAAK4GAAATEgAAeB0AAN0IAABCFAAApx8AAFEXAAC2AgAA
| Gw4AAIAZAADlBAAAShAAAK8bAAAUBwAAeRIAAN4dAABDCQAAqBQAAA0AAAByCwAA1xYAADwCAAChDQAABhkAAGsEAADQDwAA
| NRsAAJoGAAD/EQAAZB0AAMkIAAAuFAAAkx8AAPgKAABdFgAAwgEAACcNAACMGAAA8QMAAFYPAAC7GgAAIAYAAIURAADqHAAA
| TwgAALQTAAAZHwAAfgoAAOMVAABIAQAArQwAABIYAAB3AwAA3A4AAEEaAACmBQAACxEAAHAcAADVBwAAOhMAAJ8eAAAECgAA
| aRUAAM4AAAAzDAAAmBcAAP0CAABiDgAAxxkAACwFAACREAAA9hsAAFsHAADAEgAAJR4AAIoJAADvFAAAVAAAALkLAAAeFwAA
| gwIAAOgNAABNGQAAsgQAABcQAAB8GwAA4QYAAEYSAACrHQAAEAkAAHUUAADaHwAAPwsAAKQWAAAJAgAAbg0AANMYAAA4BAAA
| nQ8AAAIbAABnBgAAzBEAADEdAACWCAAA+xMAAGAfAADFCgAAKhYAAI8BAAD0DAAAWRgAAL4DAAAjDwAAiBoAAO0FAABSEQAA
| txwAABwIAACBEwAA5h4AAEsKAACwFQAAFQEAAHoMAADfFwAARAMAAKkOAAAOGgAAcwUAANgQAAA9HAAAogcAAAcTAABsHgAA
| 0QkAADYVAACbAAAAAAwAAGUXAADKAgAALw4AAJQZAAD5BAAAXhAAAMMbAAAoBwAAjRIAAPIdAABXCQAAvBQAACEAAACGCwAA
| 6xYAAFACAAC1DQAAGhkAAH8EAADkDwAASRsAAK4GAAATEgAAeB0AAN0IAABCFAAApx8AAAwLAABxFgAA1gEAADsNAACgGAAA
| BQQAAGoPAADPGgAANAYAAJkRAAD+HAAAYwgAAMgTAAAtHwAAkgoAAPcVAABcAQAAwQwAACYYAACLAwAA8A4AAFUaAAC6BQAA
| HxEAAIQcAADpBwAAThMAALMeAAAYCgAAfRUAAOIAAABHDAAArBcAABEDAAB2DgAA2xkAAEAFAAClEAAAChwAAG8HAADUEgAA
| OR4AAJ4JAAADFQAAaAAAAM0LAAAyFwAAlwIAAPwNAABhGQAAxgQAACsQAACQGwAA9QYAAFoSAAC/HQAAJAkAAIkUAADuHwAA
| UwsAALgWAAAdAgAAgg0AAOcYAABMBAAAsQ8AABYbAAB7BgAA4BEAAEUdAACqCAAADxQAAHQfAADZCgAAPhYAAKMBAAAIDQAA
| bRgAANIDAAA3DwAAnBoAAAEGAABmEQAAyxwAADAIAACVEwAA+h4AAF8KAADEFQAAKQEAAI4MAADzFwAAWAMAAL0OAAAiGgAA
| hwUAAOwQAACWCAAA+xMAAGAfAADFCgAAKhYAAI8BAAD0DAAAWRgAAL4DAAAjDwAAiBoAAO0FAABSEQAAtxwAABwIAACBEwAA
| 5h4AAEsKAACwFQAAFQEAAHoMAADfFwAARAMAAKkOAAAOGgAAcwUAANgQAAA9HAAAogcAAAcTAABsHgAA0QkAADYVAACbAAAA
| AAwAAGUXAADKAgAALw4AAJQZAAD5BAAAXhAAAMMbAAAoBwAAjRIAAPIdAABXCQAAvBQAACEAAACGCwAA6xYAAFACAAC1DQAA
| GhkAAH8EAADkDwAASRsAAK4GAAATEgAAeB0AAN0IAABCFAAApx8AAAwLAABxFgAA1gEAADsNAACgGAAABQQAAGoPAADPGgAA
| NAYAAJkRAAD+HAAAYwgAAMgTAAAtHwAAkgoAAPcVAABcAQAAwQwAACYYAACLAwAA8A4AAFUaAAC6BQAAHxEAAIQcAADpBwAA
| ThMAALMeAAAYCgAAfRUAAOIAAABHDAAArBcAABEDAAB2DgAA2xkAAEAFAAClEAAAChwAAG8HAADUEgAAOR4AAJ4JAAADFQAA
| aAAAAM0LAAAyFwAAlwIAAPwNAABhGQAAxgQAACsQAACQGwAA9QYAAFoSAAC/HQAAJAkAAIkUAADuHwAAUwsAALgWAAAdAgAA
| gg0AAOcYAABMBAAAsQ8AABYbAAB7BgAA4BEAAEUdAACqCAAADxQAAHQfAADZCgAAPhYAAKMBAAAIDQAAbRgAANIDAAA3DwAA
| nBoAAAEGAABmEQAAyxwAADAIAACVEwAA+h4AAF8KAADEFQAAKQEAAI4MAADzFwAAWAMAAL0OAAAiGgAAhwUAAOwQAABRHAAA
| tgcAABsTAACAHgAA5QkAAEoVAACvAAAAFAwAAHkXAADeAgAAQw4AAKgZAAANBQAAchAAANcbAAA8BwAAoRIAAAYeAABrCQAA
| 0BQAADUAAACaCwAA/xYAAGQCAADJDQAALhkAAJMEAAD4DwAAXRsAAMIGAAAnEgAAjB0AAPEIAABWFAAAux8AACALAACFFgAA
| 6gEAAE8NAAC0GAAAGQQAAH4PAADjGgAASAYAAK0RAAASHQAAdwgAANwTAABBHwAApgoAAAsWAABwAQAA1QwAADoYAACfAwAA
| BA8AAGkaAADOBQAAMxEAAJgcAAD9BwAAYhMAAMceAAAsCgAAkRUAAPYAAABbDAAAwBcAACUDAACKDgAA7xkAAFQFAAC5EAAA
| HhwAAIMHAADoEgAATR4AALIJAAAXFQAAfAAAAOELAABGFwAAqwIAABAOAAB1GQAA2gQAAD8QAACkGwAACQcAAG4SAADTHQAA
| OAkAAJ0UAAACAAAAZwsAAMwWAAAxAgAA2xkAAEAFAAClEAAAChwAAG8HAADUEgAAOR4AAJ4JAAADFQAAaAAAAM0LAAAyFwAA
| lwIAAPwNAABhGQAAxgQAACsQAACQGwAA9QYAAFoSAAC/HQAAJAkAAIkUAADuHwAAUwsAALgWAAAdAgAAgg0AAOcYAABMBAAA
| sQ8AABYbAAB7BgAA4BEAAEUdAACqCAAADxQAAHQfAADZCgAAPhYAAKMBAAAIDQAAbRgAANIDAAA3DwAAnBoAAAEGAABmEQAA
| yxwAADAIAACVEwAA+h4AAF8KAADEFQAAKQEAAI4MAADzFwAAWAMAAL0OAAAiGgAAhwUAAOwQAABRHAAAtgcAABsTAACAHgAA
| 5QkAAEoVAACvAAAAFAwAAHkXAADeAgAAQw4AAKgZAAANBQAAchAAANcbAAA8BwAAoRIAAAYeAABrCQAA0BQAADUAAACaCwAA
| /xYAAGQCAADJDQAALhkAAJMEAAD4DwAAXRsAAMIGAAAnEgAAjB0AAPEIAABWFAAAux8AACALAACFFgAA6gEAAE8NAAC0GAAA
| GQQAAH4PAADjGgAASAYAAK0RAAASHQAAdwgAANwTAABBHwAApgoAAAsWAABwAQAA1QwAADoYAACfAwAABA8AAGkaAADOBQAA
| MxEAAJgcAAD9BwAAYhMAAMceAAAsCgAAkRUAAPYAAABbDAAAwBcAACUDAACKDgAA7xkAAFQFAAC5EAAAHhwAAIMHAADoEgAA
| TR4AALIJAAAXFQAAfAAAAOELAABGFwAAqwIAABAOAAB1GQAA2gQAAD8QAACkGwAACQcAAG4SAADTHQAAOAkAAJ0UAAACAAAA
| ZwsAAMwWAAAxAgAAlg0AAPsYAABgBAAAxQ8AACobAACPBgAA9BEAAFkdAAC+CAAAIxQAAIgfAADtCgAAUhYAALcBAAAcDQAA
| gRgAAOYDAABLDwAAsBoAABUGAAB6EQAA3xwAAEQIAACpEwAADh8AAHMKAADYFQAAPQEAAKIMAAAHGAAAbAMAANEOAAA2GgAA
| mwUAAAARAABlHAAAygcAAC8TAACUHgAA+QkAAF4VAADDAAAAKAwAAI0XAADyAgAAVw4AALwZAAAhBQAAhhAAAOsbAABQBwAA
| tRIAABoeAAB/CQAA5BQAAEkAAACuCwAAExcAAHgCAADdDQAAQhkAAKcEAAAMEAAAcRsAANYGAAA7EgAAoB0AAAUJAABqFAAA
| zx8AADQLAACZFgAA/gEAAGMNAADIGAAALQQAAJIPAAD3GgAAXAYAAMERAAAmHQAAiwgAAPATAABVHwAAugoAAB8WAACEAQAA
| 6QwAAE4YAACzAwAAGA8AAH0aAADiBQAARxEAAKwcAAARCAAAdhMAACALAACFFgAA6gEAAE8NAAC0GAAAGQQAAH4PAADjGgAA
| SAYAAK0RAAASHQAAdwgAANwTAABBHwAApgoAAAsWAABwAQAA1QwAADoYAACfAwAABA8AAGkaAADOBQAAMxEAAJgcAAD9BwAA
| YhMAAMceAAAsCgAAkRUAAPYAAABbDAAAwBcAACUDAACKDgAA7xkAAFQFAAC5EAAAHhwAAIMHAADoEgAATR4AALIJAAAXFQAA
| fAAAAOELAABGFwAAqwIAABAOAAB1GQAA2gQAAD8QAACkGwAACQcAAG4SAADTHQAAOAkAAJ0UAAACAAAAZwsAAMwWAAAxAgAA
| lg0AAPsYAABgBAAAxQ8AACobAACPBgAA9BEAAFkdAAC+CAAAIxQAAIgfAADtCgAAUhYAALcBAAAcDQAAgRgAAOYDAABLDwAA
| sBoAABUGAAB6EQAA3xwAAEQIAACpEwAADh8AAHMKAADYFQAAPQEAAKIMAAAHGAAAbAMAANEOAAA2GgAAmwUAAAARAABlHAAA
| ygcAAC8TAACUHgAA+QkAAF4VAADDAAAAKAwAAI0XAADyAgAAVw4AALwZAAAhBQAAhhAAAOsbAABQBwAAtRIAABoeAAB/CQAA
| 5BQAAEkAAACuCwAAExcAAHgCAADdDQAAQhkAAKcEAAAMEAAAcRsAANYGAAA7EgAAoB0AAAUJAABqFAAAzx8AADQLAACZFgAA
| /gEAAGMNAADIGAAALQQAAJIPAAD3GgAAXAYAAMERAAAmHQAAiwgAAPATAABVHwAAugoAAB8WAACEAQAA6QwAAE4YAACzAwAA
| GA8AAH0aAADiBQAARxEAAKwcAAARCAAAdhMAANseAABACgAApRUAAAoBAABvDAAA1BcAADkDAACeDgAAAxoAAGgFAADNEAAA
| MhwAAJcHAAD8EgAAYR4AAMYJAAArFQAAkAAAAPULAABaFwAAvwIAACQOAACJGQAA7gQAAFMQAAC4GwAAHQcAAIISAADnHQAA
| TAkAALEUAAAWAAAAewsAAOAWAABFAgAAqg0AAA8ZAAB0BAAA2Q8AAD4bAACjBgAACBIAAG0dAADSCAAANxQAAJwfAAABCwAA
| ZhYAAMsBAAAwDQAAlRgAAPoDAABfDwAAxBoAACkGAACOEQAA8xwAAFgIAAC9EwAAIh8AAIcKAADsFQAAUQEAALYMAAAbGAAA
| gAMAAOUOAABKGgAArwUAABQRAAB5HAAA3gcAAEMTAACoHgAADQoAAHIVAADXAAAAPAwAAKEXAAAGAwAAaw4AANAZAAA1BQAA
| mhAAAP8bAABkBwAAyRIAAC4eAACTCQAA+BQAAF0AAADCCwAAJxcAAIwCAADxDQAAVhkAALsEAABlHAAAygcAAC8TAACUHgAA
| +QkAAF4VAADDAAAAKAwAAI0XAADyAgAAVw4AALwZAAAhBQAAhhAAAOsbAABQBwAAtRIAABoeAAB/CQAA5BQAAEkAAACuCwAA
| ExcAAHgCAADdDQAAQhkAAKcEAAAMEAAAcRsAANYGAAA7EgAAoB0AAAUJAABqFAAAzx8AADQLAACZFgAA/gEAAGMNAADIGAAA
| LQQAAJIPAAD3GgAAXAYAAMERAAAmHQAAiwgAAPATAABVHwAAugoAAB8WAACEAQAA6QwAAE4YAACzAwAAGA8AAH0aAADiBQAA
| RxEAAKwcAAARCAAAdhMAANseAABACgAApRUAAAoBAABvDAAA1BcAADkDAACeDgAAAxoAAGgFAADNEAAAMhwAAJcHAAD8EgAA
| YR4AAMYJAAArFQAAkAAAAPULAABaFwAAvwIAACQOAACJGQAA7gQAAFMQAAC4GwAAHQcAAIISAADnHQAATAkAALEUAAAWAAAA
| ewsAAOAWAABFAgAAqg0AAA8ZAAB0BAAA2Q8AAD4bAACjBgAACBIAAG0dAADSCAAANxQAAJwfAAABCwAAZhYAAMsBAAAwDQAA
| lRgAAPoDAABfDwAAxBoAACkGAACOEQAA8xwAAFgIAAC9EwAAIh8AAIcKAADsFQAAUQEAALYMAAAbGAAAgAMAAOUOAABKGgAA
| rwUAABQRAAB5HAAA3gcAAEMTAACoHgAADQoAAHIVAADXAAAAPAwAAKEXAAAGAwAAaw4AANAZAAA1BQAAmhAAAP8bAABkBwAA
| yRIAAC4eAACTCQAA+BQAAF0AAADCCwAAJxcAAIwCAADxDQAAVhkAALsEAAAgEAAAhRsAAOoGAABPEgAAtB0AABkJAAB+FAAA
| 4x8AAEgLAACtFgAAEgIAAHcNAADcGAAAQQQAAKYPAAALGwAAcAYAANURAAA6HQAAnwgAAAQUAABpHwAAzgoAADMWAACYAQAA
| /QwAAGIYAADHAwAALA8AAJEaAAD2BQAAWxEAAMAcAAAlCAAAihMAAO8eAABUCgAAuRUAAB4BAACDDAAA6BcAAE0DAACyDgAA
| FxoAAHwFAADhEAAARhwAAKsHAAAQEwAAdR4AANoJAAA/FQAApAAAAAkMAABuFwAA0wIAADgOAACdGQAAAgUAAGcQAADMGwAA
| MQcAAJYSAAD7HQAAYAkAAMUUAAAqAAAAjwsAAPQWAABZAgAAvg0AACMZAACIBAAA7Q8AAFIbAAC3BgAAHBIAAIEdAADmCAAA
| SxQAALAfAAAVCwAAehYAAN8BAABEDQAAqRgAAA4EAABzDwAA2BoAAD0GAACiEQAABx0AAGwIAADREwAANh8AAJsKAAAAFgAA
| qg0AAA8ZAAB0BAAA2Q8AAD4bAACjBgAACBIAAG0dAADSCAAANxQAAJwfAAABCwAAZhYAAMsBAAAwDQAAlRgAAPoDAABfDwAA
| xBoAACkGAACOEQAA8xwAAFgIAAC9EwAAIh8AAIcKAADsFQAAUQEAALYMAAAbGAAAgAMAAOUOAABKGgAArwUAABQRAAB5HAAA
| 3gcAAEMTAACoHgAADQoAAHIVAADXAAAAPAwAAKEXAAAGAwAAaw4AANAZAAA1BQAAmhAAAP8bAABkBwAAyRIAAC4eAACTCQAA
| +BQAAF0AAADCCwAAJxcAAIwCAADxDQAAVhkAALsEAAAgEAAAhRsAAOoGAABPEgAAtB0AABkJAAB+FAAA4x8AAEgLAACtFgAA
| EgIAAHcNAADcGAAAQQQAAKYPAAALGwAAcAYAANURAAA6HQAAnwgAAAQUAABpHwAAzgoAADMWAACYAQAA/QwAAGIYAADHAwAA
| LA8AAJEaAAD2BQAAWxEAAMAcAAAlCAAAihMAAO8eAABUCgAAuRUAAB4BAACDDAAA6BcAAE0DAACyDgAAFxoAAHwFAADhEAAA
| RhwAAKsHAAAQEwAAdR4AANoJAAA/FQAApAAAAAkMAABuFwAA0wIAADgOAACdGQAAAgUAAGcQAADMGwAAMQcAAJYSAAD7HQAA
| YAkAAMUUAAAqAAAAjwsAAPQWAABZAgAAvg0AACMZAACIBAAA7Q8AAFIbAAC3BgAAHBIAAIEdAADmCAAASxQAALAfAAAVCwAA
| ehYAAN8BAABEDQAAqRgAAA4EAABzDwAA2BoAAD0GAACiEQAABx0AAGwIAADREwAANh8AAJsKAAAAFgAAZQEAAMoMAAAvGAAA
| lAMAAPkOAABeGgAAwwUAACgRAACNHAAA8gcAAFcTAAC8HgAAIQoAAIYVAADrAAAAUAwAALUXAAAaAwAAfw4AAOQZAABJBQAA
| rhAAABMcAAB4BwAA3RIAAEIeAACnCQAADBUAAHEAAADWCwAAOxcAAKACAAAFDgAAahkAAM8EAAA0EAAAmRsAAP4GAABjEgAA
| yB0AAC0JAACSFAAA9x8AAFwLAADBFgAAJgIAAIsNAADwGAAAVQQAALoPAAAfGwAAhAYAAOkRAABOHQAAswgAABgUAAB9HwAA
| 4goAAEcWAACsAQAAEQ0AAHYYAADbAwAAQA8AAKUaAAAKBgAAbxEAANQcAAA5CAAAnhMAAAMfAABoCgAAzRUAADIBAACXDAAA
| /BcAAGEDAADGDgAAKxoAAJAFAAD1EAAAWhwAAL8HAAAkEwAAiR4AAO4JAABTFQAAuAAAAB0MAACCFwAA5wIAAEwOAACxGQAA
| FgUAAHsQAADgGwAARQcAAO8eAABUCgAAuRUAAB4BAACDDAAA6BcAAE0DAACyDgAAFxoAAHwFAADhEAAARhwAAKsHAAAQEwAA
| dR4AANoJAAA/FQAApAAAAAkMAABuFwAA0wIAADgOAACdGQAAAgUAAGcQAADMGwAAMQcAAJYSAAD7HQAAYAkAAMUUAAAqAAAA
| jwsAAPQWAABZAgAAvg0AACMZAACIBAAA7Q8AAFIbAAC3BgAAHBIAAIEdAADmCAAASxQAALAfAAAVCwAAehYAAN8BAABEDQAA
| qRgAAA4EAABzDwAA2BoAAD0GAACiEQAABx0AAGwIAADREwAANh8AAJsKAAAAFgAAZQEAAMoMAAAvGAAAlAMAAPkOAABeGgAA
| wwUAACgRAACNHAAA8gcAAFcTAAC8HgAAIQoAAIYVAADrAAAAUAwAALUXAAAaAwAAfw4AAOQZAABJBQAArhAAABMcAAB4BwAA
| 3RIAAEIeAACnCQAADBUAAHEAAADWCwAAOxcAAKACAAAFDgAAahkAAM8EAAA0EAAAmRsAAP4GAABjEgAAyB0AAC0JAACSFAAA
| 9x8AAFwLAADBFgAAJgIAAIsNAADwGAAAVQQAALoPAAAfGwAAhAYAAOkRAABOHQAAswgAABgUAAB9HwAA4goAAEcWAACsAQAA
| EQ0AAHYYAADbAwAAQA8AAKUaAAAKBgAAbxEAANQcAAA5CAAAnhMAAAMfAABoCgAAzRUAADIBAACXDAAA/BcAAGEDAADGDgAA
| KxoAAJAFAAD1EAAAWhwAAL8HAAAkEwAAiR4AAO4JAABTFQAAuAAAAB0MAACCFwAA5wIAAEwOAACxGQAAFgUAAHsQAADgGwAA
| RQcAAKoSAAAPHgAAdAkAANkUAAA+AAAAowsAAAgXAABtAgAA0g0AADcZAACcBAAAARAAAGYbAADLBgAAMBIAAJUdAAD6CAAA
| XxQAAMQfAAApCwAAjhYAAPMBAABYDQAAvRgAACIEAACHDwAA7BoAAFEGAAC2EQAAGx0AAIAIAADlEwAASh8AAK8KAAAUFgAA
| eQEAAN4MAABDGAAAqAMAAA0PAAByGgAA1wUAADwRAAChHAAABggAAGsTAADQHgAANQoAAJoVAAD/AAAAZAwAAMkXAAAuAwAA
| kw4AAPgZAABdBQAAwhAAACccAACMBwAA8RIAAFYeAAC7CQAAIBUAAIUAAADqCwAATxcAALQCAAAZDgAAfhkAAOMEAABIEAAA
| rRsAABIHAAB3EgAA3B0AAEEJAACmFAAACwAAAHALAADVFgAAOgIAAJ8NAAAEGQAAaQQAAM4PAAAzGwAAmAYAAP0RAABiHQAA
| xwgAACwUAACRHwAA9goAAFsWAADAAQAAJQ0AAIoYAAA0EAAAmRsAAP4GAABjEgAAyB0AAC0JAACSFAAA9x8AAFwLAADBFgAA
| JgIAAIsNAADwGAAAVQQAALoPAAAfGwAAhAYAAOkRAABOHQAAswgAABgUAAB9HwAA4goAAEcWAACsAQAAEQ0AAHYYAADbAwAA
| QA8AAKUaAAAKBgAAbxEAANQcAAA5CAAAnhMAAAMfAABoCgAAzRUAADIBAACXDAAA/BcAAGEDAADGDgAAKxoAAJAFAAD1EAAA
| WhwAAL8HAAAkEwAAiR4AAO4JAABTFQAAuAAAAB0MAACCFwAA5wIAAEwOAACxGQAAFgUAAHsQAADgGwAARQcAAKoSAAAPHgAA
| dAkAANkUAAA+AAAAowsAAAgXAABtAgAA0g0AADcZAACcBAAAARAAAGYbAADLBgAAMBIAAJUdAAD6CAAAXxQAAMQfAAApCwAA
| jhYAAPMBAABYDQAAvRgAACIEAACHDwAA7BoAAFEGAAC2EQAAGx0AAIAIAADlEwAASh8AAK8KAAAUFgAAeQEAAN4MAABDGAAA
| qAMAAA0PAAByGgAA1wUAADwRAAChHAAABggAAGsTAADQHgAANQoAAJoVAAD/AAAAZAwAAMkXAAAuAwAAkw4AAPgZAABdBQAA
| whAAACccAACMBwAA8RIAAFYeAAC7CQAAIBUAAIUAAADqCwAATxcAALQCAAAZDgAAfhkAAOMEAABIEAAArRsAABIHAAB3EgAA
| 3B0AAEEJAACmFAAACwAAAHALAADVFgAAOgIAAJ8NAAAEGQAAaQQAAM4PAAAzGwAAmAYAAP0RAABiHQAAxwgAACwUAACRHwAA
| 9goAAFsWAADAAQAAJQ0AAIoYAADvAwAAVA8AALkaAAAeBgAAgxEAAOgcAABNCAAAshMAABcfAAB8CgAA4RUAAEYBAACrDAAA
| EBgAAHUDAADaDgAAPxoAAKQFAAAJEQAAbhwAANMHAAA4EwAAnR4AAAIKAABnFQAAzAAAADEMAACWFwAA+wIAAGAOAADFGQAA
| KgUAAI8QAAD0GwAAWQcAAL4SAAAjHgAAiAkAAO0UAABSAAAAtwsAABwXAACBAgAA5g0AAEsZAACwBAAAFRAAAHobAADfBgAA
| RBIAAKkdAAAOCQAAcxQAANgfAAA9CwAAohYAAAcCAABsDQAA0RgAADYEAACbDwAAABsAAGUGAADKEQAALx0AAJQIAAD5EwAA
| Xh8AAMMKAAAoFgAAjQEAAPIMAABXGAAAvAMAACEPAACGGgAA6wUAAFARAAC1HAAAGggAAH8TAADkHgAASQoAAK4VAAATAQAA
| eAwAAN0XAABCAwAApw4AAAwaAABxBQAA1hAAADscAACgBwAABRMAAGoeAADPCQAAeQEAAN4MAABDGAAAqAMAAA0PAAByGgAA
| 1wUAADwRAAChHAAABggAAGsTAADQHgAANQoAAJoVAAD/AAAAZAwAAMkXAAAuAwAAkw4AAPgZAABdBQAAwhAAACccAACMBwAA
| 8RIAAFYeAAC7CQAAIBUAAIUAAADqCwAATxcAALQCAAAZDgAAfhkAAOMEAABIEAAArRsAABIHAAB3EgAA3B0AAEEJAACmFAAA
| CwAAAHALAADVFgAAOgIAAJ8NAAAEGQAAaQQAAM4PAAAzGwAAmAYAAP0RAABiHQAAxwgAACwUAACRHwAA9goAAFsWAADAAQAA
| JQ0AAIoYAADvAwAAVA8AALkaAAAeBgAAgxEAAOgcAABNCAAAshMAABcfAAB8CgAA4RUAAEYBAACrDAAAEBgAAHUDAADaDgAA
| PxoAAKQFAAAJEQAAbhwAANMHAAA4EwAAnR4AAAIKAABnFQAAzAAAADEMAACWFwAA+wIAAGAOAADFGQAAKgUAAI8QAAD0GwAA
| WQcAAL4SAAAjHgAAiAkAAO0UAABSAAAAtwsAABwXAACBAgAA5g0AAEsZAACwBAAAFRAAAHobAADfBgAARBIAAKkdAAAOCQAA
| cxQAANgfAAA9CwAAohYAAAcCAABsDQAA0RgAADYEAACbDwAAABsAAGUGAADKEQAALx0AAJQIAAD5EwAAXh8AAMMKAAAoFgAA
| jQEAAPIMAABXGAAAvAMAACEPAACGGgAA6wUAAFARAAC1HAAAGggAAH8TAADkHgAASQoAAK4VAAATAQAAeAwAAN0XAABCAwAA
| pw4AAAwaAABxBQAA1hAAADscAACgBwAABRMAAGoeAADPCQAANBUAAJkAAAD+CwAAYxcAAMgCAAAtDgAAkhkAAPcEAABcEAAA
| wRsAACYHAACLEgAA8B0AAFUJAAC6FAAAHwAAAIQLAADpFgAATgIAALMNAAAYGQAAfQQAAOIPAABHGwAArAYAABESAAB2HQAA
| 2wgAAEAUAAClHwAACgsAAG8WAADUAQAAOQ0AAJ4YAAADBAAAaA8AAM0aAAAyBgAAlxEAAPwcAABhCAAAxhMAACsfAACQCgAA
| 9RUAAFoBAAC/DAAAJBgAAIkDAADuDgAAUxoAALgFAAAdEQAAghwAAOcHAABMEwAAsR4AABYKAAB7FQAA4AAAAEUMAACqFwAA
| DwMAAHQOAADZGQAAPgUAAKMQAAAIHAAAbQcAANISAAA3HgAAnAkAAAEVAABmAAAAywsAADAXAACVAgAA+g0AAF8ZAADEBAAA
| KRAAAI4bAADzBgAAWBIAAL0dAAAiCQAAhxQAAOwfAABRCwAAthYAABsCAACADQAA5RgAAEoEAACvDwAAFBsAAL4SAAAjHgAA
| iAkAAO0UAABSAAAAtwsAABwXAACBAgAA5g0AAEsZAACwBAAAFRAAAHobAADfBgAARBIAAKkdAAAOCQAAcxQAANgfAAA9CwAA
| ohYAAAcCAABsDQAA0RgAADYEAACbDwAAABsAAGUGAADKEQAALx0AAJQIAAD5EwAAXh8AAMMKAAAoFgAAjQEAAPIMAABXGAAA
| vAMAACEPAACGGgAA6wUAAFARAAC1HAAAGggAAH8TAADkHgAASQoAAK4VAAATAQAAeAwAAN0XAABCAwAApw4AAAwaAABxBQAA
| 1hAAADscAACgBwAABRMAAGoeAADPCQAANBUAAJkAAAD+CwAAYxcAAMgCAAAtDgAAkhkAAPcEAABcEAAAwRsAACYHAACLEgAA
| 8B0AAFUJAAC6FAAAHwAAAIQLAADpFgAATgIAALMNAAAYGQAAfQQAAOIPAABHGwAArAYAABESAAB2HQAA2wgAAEAUAAClHwAA
| CgsAAG8WAADUAQAAOQ0AAJ4YAAADBAAAaA8AAM0aAAAyBgAAlxEAAPwcAABhCAAAxhMAACsfAACQCgAA9RUAAFoBAAC/DAAA
| JBgAAIkDAADuDgAAUxoAALgFAAAdEQAAghwAAOcHAABMEwAAsR4AABYKAAB7FQAA4AAAAEUMAACqFwAADwMAAHQOAADZGQAA
| PgUAAKMQAAAIHAAAbQcAANISAAA3HgAAnAkAAAEVAABmAAAAywsAADAXAACVAgAA+g0AAF8ZAADEBAAAKRAAAI4bAADzBgAA
| WBIAAL0dAAAiCQAAhxQAAOwfAABRCwAAthYAABsCAACADQAA5RgAAEoEAACvDwAAFBsAAHkGAADeEQAAQx0AAKgIAAANFAAA
| ch8AANcKAAA8FgAAoQEAAAYNAABrGAAA0AMAADUPAACaGgAA/wUAAGQRAADJHAAALggAAJMTAAD4HgAAXQoAAMIVAAAnAQAA
| jAwAAPEXAABWAwAAuw4AACAaAACFBQAA6hAAAE8cAAC0BwAAGRMAAH4eAADjCQAASBUAAK0AAAASDAAAdxcAANwCAABBDgAA
| phkAAAsFAABwEAAA1RsAADoHAACfEgAABB4AAGkJAADOFAAAMwAAAJgLAAD9FgAAYgIAAMcNAAAsGQAAkQQAAPYPAABbGwAA
| wAYAACUSAACKHQAA7wgAAFQUAAC5HwAAHgsAAIMWAADoAQAATQ0AALIYAAAXBAAAfA8AAOEaAABGBgAAqxEAABAdAAB1CAAA
| 2hMAAD8fAACkCgAACRYAAG4BAADTDAAAOBgAAJ0DAAACDwAAZxoAAMwFAAAxEQAAlhwAAPsHAABgEwAAxR4AACoKAACPFQAA
| 9AAAAFkMAAADBAAAaA8AAM0aAAAyBgAAlxEAAPwcAABhCAAAxhMAACsfAACQCgAA9RUAAFoBAAC/DAAAJBgAAIkDAADuDgAA
| UxoAALgFAAAdEQAAghwAAOcHAABMEwAAsR4AABYKAAB7FQAA4AAAAEUMAACqFwAADwMAAHQOAADZGQAAPgUAAKMQAAAIHAAA
| bQcAANISAAA3HgAAnAkAAAEVAABmAAAAywsAADAXAACVAgAA+g0AAF8ZAADEBAAAKRAAAI4bAADzBgAAWBIAAL0dAAAiCQAA
| hxQAAOwfAABRCwAAthYAABsCAACADQAA5RgAAEoEAACvDwAAFBsAAHkGAADeEQAAQx0AAKgIAAANFAAAch8AANcKAAA8FgAA
| oQEAAAYNAABrGAAA0AMAADUPAACaGgAA/wUAAGQRAADJHAAALggAAJMTAAD4HgAAXQoAAMIVAAAnAQAAjAwAAPEXAABWAwAA
| uw4AACAaAACFBQAA6hAAAE8cAAC0BwAAGRMAAH4eAADjCQAASBUAAK0AAAASDAAAdxcAANwCAABBDgAAphkAAAsFAABwEAAA
| 1RsAADoHAACfEgAABB4AAGkJAADOFAAAMwAAAJgLAAD9FgAAYgIAAMcNAAAsGQAAkQQAAPYPAABbGwAAwAYAACUSAACKHQAA
| 7wgAAFQUAAC5HwAAHgsAAIMWAADoAQAATQ0AALIYAAAXBAAAfA8AAOEaAABGBgAAqxEAABAdAAB1CAAA2hMAAD8fAACkCgAA
| CRYAAG4BAADTDAAAOBgAAJ0DAAACDwAAZxoAAMwFAAAxEQAAlhwAAPsHAABgEwAAxR4AACoKAACPFQAA9AAAAFkMAAC+FwAA
| IwMAAIgOAADtGQAAUgUAALcQAAAcHAAAgQcAAOYSAABLHgAAsAkAABUVAAB6AAAA3wsAAEQXAACpAgAADg4AAHMZAADYBAAA
| PRAAAKIbAAAHBwAAbBIAANEdAAA2CQAAmxQAAAAAAABlCwAAyhYAAC8CAACUDQAA+RgAAF4EAADDDwAAKBsAAI0GAADyEQAA
| Vx0AALwIAAAhFAAAhh8AAOsKAABQFgAAtQEAABoNAAB/GAAA5AMAAEkPAACuGgAAEwYAAHgRAADdHAAAQggAAKcTAAAMHwAA
| cQoAANYVAAA7AQAAoAwAAAUYAABqAwAAzw4AADQaAACZBQAA/hAAAGMcAADIBwAALRMAAJIeAAD3CQAAXBUAAMEAAAAmDAAA
| ixcAAPACAABVDgAAuhkAAB8FAACEEAAA6RsAAE4HAACzEgAAGB4AAH0JAADiFAAARwAAAKwLAAARFwAAdgIAANsNAABAGQAA
| pQQAAAoQAABvGwAA1AYAADkSAACeHQAASBUAAK0AAAASDAAAdxcAANwCAABBDgAAphkAAAsFAABwEAAA1RsAADoHAACfEgAA
| BB4AAGkJAADOFAAAMwAAAJgLAAD9FgAAYgIAAMcNAAAsGQAAkQQAAPYPAABbGwAAwAYAACUSAACKHQAA7wgAAFQUAAC5HwAA
| HgsAAIMWAADoAQAATQ0AALIYAAAXBAAAfA8AAOEaAABGBgAAqxEAABAdAAB1CAAA2hMAAD8fAACkCgAACRYAAG4BAADTDAAA
| OBgAAJ0DAAACDwAAZxoAAMwFAAAxEQAAlhwAAPsHAABgEwAAxR4AACoKAACPFQAA9AAAAFkMAAC+FwAAIwMAAIgOAADtGQAA
| UgUAALcQAAAcHAAAgQcAAOYSAABLHgAAsAkAABUVAAB6AAAA3wsAAEQXAACpAgAADg4AAHMZAADYBAAAPRAAAKIbAAAHBwAA
| bBIAANEdAAA2CQAAmxQAAAAAAABlCwAAyhYAAC8CAACUDQAA+RgAAF4EAADDDwAAKBsAAI0GAADyEQAAVx0AALwIAAAhFAAA
| hh8AAOsKAABQFgAAtQEAABoNAAB/GAAA5AMAAEkPAACuGgAAEwYAAHgRAADdHAAAQggAAKcTAAAMHwAAcQoAANYVAAA7AQAA
| oAwAAAUYAABqAwAAzw4AADQaAACZBQAA/hAAAGMcAADIBwAALRMAAJIeAAD3CQAAXBUAAMEAAAAmDAAAixcAAPACAABVDgAA
| uhkAAB8FAACEEAAA6RsAAE4HAACzEgAAGB4AAH0JAADiFAAARwAAAKwLAAARFwAAdgIAANsNAABAGQAApQQAAAoQAABvGwAA
| 1AYAADkSAACeHQAAAwkAAGgUAADNHwAAMgsAAJcWAAD8AQAAYQ0AAMYYAAArBAAAkA8AAPUaAABaBgAAvxEAACQdAACJCAAA
| 7hMAAFMfAAC4CgAAHRYAAIIBAADnDAAATBgAALEDAAAWDwAAexoAAOAFAABFEQAAqhwAAA8IAAB0EwAA2R4AAD4KAACjFQAA
| CAEAAG0MAADSFwAANwMAAJwOAAABGgAAZgUAAMsQAAAwHAAAlQcAAPoSAABfHgAAxAkAACkVAACOAAAA8wsAAFgXAAC9AgAA
| Ig4AAIcZAADsBAAAURAAALYbAAAbBwAAgBIAAOUdAABKCQAArxQAABQAAAB5CwAA3hYAAEMCAACoDQAADRkAAHIEAADXDwAA
| PBsAAKEGAAAGEgAAax0AANAIAAA1FAAAmh8AAP8KAABkFgAAyQEAAC4NAACTGAAA+AMAAF0PAADCGgAAJwYAAIwRAADxHAAA
| VggAALsTAAAgHwAAhQoAAOoVAABPAQAAtAwAABkYAAB+AwAA4w4AAI0GAADyEQAAVx0AALwIAAAhFAAAhh8AAOsKAABQFgAA
| tQEAABoNAAB/GAAA5AMAAEkPAACuGgAAEwYAAHgRAADdHAAAQggAAKcTAAAMHwAAcQoAANYVAAA7AQAAoAwAAAUYAABqAwAA
| zw4AADQaAACZBQAA/hAAAGMcAADIBwAALRMAAJIeAAD3CQAAXBUAAMEAAAAmDAAAixcAAPACAABVDgAAuhkAAB8FAACEEAAA
| 6RsAAE4HAACzEgAAGB4AAH0JAADiFAAARwAAAKwLAAARFwAAdgIAANsNAABAGQAApQQAAAoQAABvGwAA1AYAADkSAACeHQAA
| AwkAAGgUAADNHwAAMgsAAJcWAAD8AQAAYQ0AAMYYAAArBAAAkA8AAPUaAABaBgAAvxEAACQdAACJCAAA7hMAAFMfAAC4CgAA
| HRYAAIIBAADnDAAATBgAALEDAAAWDwAAexoAAOAFAABFEQAAqhwAAA8IAAB0EwAA2R4AAD4KAACjFQAACAEAAG0MAADSFwAA
| NwMAAJwOAAABGgAAZgUAAMsQAAAwHAAAlQcAAPoSAABfHgAAxAkAACkVAACOAAAA8wsAAFgXAAC9AgAAIg4AAIcZAADsBAAA
| URAAALYbAAAbBwAAgBIAAOUdAABKCQAArxQAABQAAAB5CwAA3hYAAEMCAACoDQAADRkAAHIEAADXDwAAPBsAAKEGAAAGEgAA
| ax0AANAIAAA1FAAAmh8AAP8KAABkFgAAyQEAAC4NAACTGAAA+AMAAF0PAADCGgAAJwYAAIwRAADxHAAAVggAALsTAAAgHwAA
| hQoAAOoVAABPAQAAtAwAABkYAAB+AwAA4w4AAEgaAACtBQAAEhEAAHccAADcBwAAQRMAAKYeAAALCgAAcBUAANUAAAA6DAAA
| nxcAAAQDAABpDgAAzhkAADMFAACYEAAA/RsAAGIHAADHEgAALB4AAJEJAAD2FAAAWwAAAMALAAAlFwAAigIAAO8NAABUGQAA
| uQQAAB4QAACDGwAA6AYAAE0SAACyHQAAFwkAAHwUAADhHwAARgsAAKsWAAAQAgAAdQ0AANoYAAA/BAAApA8AAAkbAABuBgAA
| 0xEAADgdAACdCAAAAhQAAGcfAADMCgAAMRYAAJYBAAD7DAAAYBgAAMUDAAAqDwAAjxoAAPQFAABZEQAAvhwAACMIAACIEwAA
| 7R4AAFIKAAC3FQAAHAEAAIEMAADmFwAASwMAALAOAAAVGgAAegUAAN8QAABEHAAAqQcAAA4TAABzHgAA2AkAAD0VAACiAAAA
| BwwAAGwXAADRAgAANg4AAJsZAAAABQAAZRAAAMobAAAvBwAAlBIAAPkdAABeCQAAwxQAACgAAADSFwAANwMAAJwOAAABGgAA
| ZgUAAMsQAAAwHAAAlQcAAPoSAABfHgAAxAkAACkVAACOAAAA8wsAAFgXAAC9AgAAIg4AAIcZAADsBAAAURAAALYbAAAbBwAA
| gBIAAOUdAABKCQAArxQAABQAAAB5CwAA3hYAAEMCAACoDQAADRkAAHIEAADXDwAAPBsAAKEGAAAGEgAAax0AANAIAAA1FAAA
| mh8AAP8KAABkFgAAyQEAAC4NAACTGAAA+AMAAF0PAADCGgAAJwYAAIwRAADxHAAAVggAALsTAAAgHwAAhQoAAOoVAABPAQAA
| tAwAABkYAAB+AwAA4w4AAEgaAACtBQAAEhEAAHccAADcBwAAQRMAAKYeAAALCgAAcBUAANUAAAA6DAAAnxcAAAQDAABpDgAA
| zhkAADMFAACYEAAA/RsAAGIHAADHEgAALB4AAJEJAAD2FAAAWwAAAMALAAAlFwAAigIAAO8NAABUGQAAuQQAAB4QAACDGwAA
| 6AYAAE0SAACyHQAAFwkAAHwUAADhHwAARgsAAKsWAAAQAgAAdQ0AANoYAAA/BAAApA8AAAkbAABuBgAA0xEAADgdAACdCAAA
| AhQAAGcfAADMCgAAMRYAAJYBAAD7DAAAYBgAAMUDAAAqDwAAjxoAAPQFAABZEQAAvhwAACMIAACIEwAA7R4AAFIKAAC3FQAA
| HAEAAIEMAADmFwAASwMAALAOAAAVGgAAegUAAN8QAABEHAAAqQcAAA4TAABzHgAA2AkAAD0VAACiAAAABwwAAGwXAADRAgAA
| Ng4AAJsZAAAABQAAZRAAAMobAAAvBwAAlBIAAPkdAABeCQAAwxQAACgAAACNCwAA8hYAAFcCAAC8DQAAIRkAAIYEAADrDwAA
| UBsAALUGAAAaEgAAfx0AAOQIAABJFAAArh8AABMLAAB4FgAA3QEAAEINAACnGAAADAQAAHEPAADWGgAAOwYAAKARAAAFHQAA
| aggAAM8TAAA0HwAAmQoAAP4VAABjAQAAyAwAAC0YAACSAwAA9w4AAFwaAADBBQAAJhEAAIscAADwBwAAVRMAALoeAAAfCgAA
| hBUAAOkAAABODAAAsxcAABgDAAB9DgAA4hkAAEcFAACsEAAAERwAAHYHAADbEgAAQB4AAKUJAAAKFQAAbwAAANQLAAA5FwAA
| ngIAAAMOAABoGQAAzQQAADIQAACXGwAA/AYAAGESAADGHQAAKwkAAJAUAAD1HwAAWgsAAL8WAAAkAgAAiQ0AAO4YAABTBAAA
| uA8AAB0bAACCBgAA5xEAAEwdAACxCAAAFhQAAHsfAADgCgAARRYAAKoBAAAPDQAAdBgAANkDAAA+DwAAoxoAAAgGAABtEQAA
| FwkAAHwUAADhHwAARgsAAKsWAAAQAgAAdQ0AANoYAAA/BAAApA8AAAkbAABuBgAA0xEAADgdAACdCAAAAhQAAGcfAADMCgAA
| MRYAAJYBAAD7DAAAYBgAAMUDAAAqDwAAjxoAAPQFAABZEQAAvhwAACMIAACIEwAA7R4AAFIKAAC3FQAAHAEAAIEMAADmFwAA
| SwMAALAOAAAVGgAAegUAAN8QAABEHAAAqQcAAA4TAABzHgAA2AkAAD0VAACiAAAABwwAAGwXAADRAgAANg4AAJsZAAAABQAA
| ZRAAAMobAAAvBwAAlBIAAPkdAABeCQAAwxQAACgAAACNCwAA8hYAAFcCAAC8DQAAIRkAAIYEAADrDwAAUBsAALUGAAAaEgAA
| fx0AAOQIAABJFAAArh8AABMLAAB4FgAA3QEAAEINAACnGAAADAQAAHEPAADWGgAAOwYAAKARAAAFHQAAaggAAM8TAAA0HwAA
| mQoAAP4VAABjAQAAyAwAAC0YAACSAwAA9w4AAFwaAADBBQAAJhEAAIscAADwBwAAVRMAALoeAAAfCgAAhBUAAOkAAABODAAA
| sxcAABgDAAB9DgAA4hkAAEcFAACsEAAAERwAAHYHAADbEgAAQB4AAKUJAAAKFQAAbwAAANQLAAA5FwAAngIAAAMOAABoGQAA
| zQQAADIQAACXGwAA/AYAAGESAADGHQAAKwkAAJAUAAD1HwAAWgsAAL8WAAAkAgAAiQ0AAO4YAABTBAAAuA8AAB0bAACCBgAA
| 5xEAAEwdAACxCAAAFhQAAHsfAADgCgAARRYAAKoBAAAPDQAAdBgAANkDAAA+DwAAoxoAAAgGAABtEQAA0hwAADcIAACcEwAA
| AR8AAGYKAADLFQAAMAEAAJUMAAD6FwAAXwMAAMQOAAApGgAAjgUAAPMQAABYHAAAvQcAACITAACHHgAA7AkAAFEVAAC2AAAA
| GwwAAIAXAADlAgAASg4AAK8ZAAAUBQAAeRAAAN4bAABDBwAAqBIAAA0eAAByCQAA1xQAADwAAAChCwAABhcAAGsCAADQDQAA
| NRkAAJoEAAD/DwAAZBsAAMkGAAAuEgAAkx0AAPgIAABdFAAAwh8AACcLAACMFgAA8QEAAFYNAAC7GAAAIAQAAIUPAADqGgAA
| TwYAALQRAAAZHQAAfggAAOMTAABIHwAArQoAABIWAAB3AQAA3AwAAEEYAACmAwAACw8AAHAaAADVBQAAOhEAAJ8cAAAECAAA
| aRMAAM4eAAAzCgAAmBUAAP0AAABiDAAAxxcAACwDAACRDgAA9hkAAFsFAADAEAAAJRwAAIoHAADvEgAAVB4AALkJAAAeFQAA
| gwAAAOgLAABNFwAAsgIAAFwaAADBBQAAJhEAAIscAADwBwAAVRMAALoeAAAfCgAAhBUAAOkAAABODAAAsxcAABgDAAB9DgAA
| 4hkAAEcFAACsEAAAERwAAHYHAADbEgAAQB4AAKUJAAAKFQAAbwAAANQLAAA5FwAAngIAAAMOAABoGQAAzQQAADIQAACXGwAA
| /AYAAGESAADGHQAAKwkAAJAUAAD1HwAAWgsAAL8WAAAkAgAAiQ0AAO4YAABTBAAAuA8AAB0bAACCBgAA5xEAAEwdAACxCAAA
| FhQAAHsfAADgCgAARRYAAKoBAAAPDQAAdBgAANkDAAA+DwAAoxoAAAgGAABtEQAA0hwAADcIAACcEwAAAR8AAGYKAADLFQAA
| MAEAAJUMAAD6FwAAXwMAAMQOAAApGgAAjgUAAPMQAABYHAAAvQcAACITAACHHgAA7AkAAFEVAAC2AAAAGwwAAIAXAADlAgAA
| Sg4AAK8ZAAAUBQAAeRAAAN4bAABDBwAAqBIAAA0eAAByCQAA1xQAADwAAAChCwAABhcAAGsCAADQDQAANRkAAJoEAAD/DwAA
| ZBsAAMkGAAAuEgAAkx0AAPgIAABdFAAAwh8AACcLAACMFgAA8QEAAFYNAAC7GAAAIAQAAIUPAADqGgAATwYAALQRAAAZHQAA
| fggAAOMTAABIHwAArQoAABIWAAB3AQAA3AwAAEEYAACmAwAACw8AAHAaAADVBQAAOhEAAJ8cAAAECAAAaRMAAM4eAAAzCgAA
| mBUAAP0AAABiDAAAxxcAACwDAACRDgAA9hkAAFsFAADAEAAAJRwAAIoHAADvEgAAVB4AALkJAAAeFQAAgwAAAOgLAABNFwAA
| sgIAABcOAAB8GQAA4QQAAEYQAACrGwAAEAcAAHUSAADaHQAAPwkAAKQUAAAJAAAAbgsAANMWAAA4AgAAnQ0AAAIZAABnBAAA
| zA8AADEbAACWBgAA+xEAAGAdAADFCAAAKhQAAI8fAAD0CgAAWRYAAL4BAAAjDQAAiBgAAO0DAABSDwAAtxoAABwGAACBEQAA
| 5hwAAEsIAACwEwAAFR8AAHoKAADfFQAARAEAAKkMAAAOGAAAcwMAANgOAAA9GgAAogUAAAcRAABsHAAA0QcAADYTAACbHgAA
| AAoAAGUVAADKAAAALwwAAJQXAAD5AgAAXg4AAMMZAAAoBQAAjRAAAPIbAABXBwAAvBIAACEeAACGCQAA6xQAAFAAAAC1CwAA
| GhcAAH8CAADkDQAASRkAAK4EAAATEAAAeBsAAN0GAABCEgAApx0AAAwJAABxFAAA1h8AADsLAACgFgAABQIAAGoNAADPGAAA
| NAQAAJkPAAD+GgAAYwYAAMgRAAAtHQAAkggAAPcTAAChCwAABhcAAGsCAADQDQAANRkAAJoEAAD/DwAAZBsAAMkGAAAuEgAA
| kx0AAPgIAABdFAAAwh8AACcLAACMFgAA8QEAAFYNAAC7GAAAIAQAAIUPAADqGgAATwYAALQRAAAZHQAAfggAAOMTAABIHwAA
| rQoAABIWAAB3AQAA3AwAAEEYAACmAwAACw8AAHAaAADVBQAAOhEAAJ8cAAAECAAAaRMAAM4eAAAzCgAAmBUAAP0AAABiDAAA
| xxcAACwDAACRDgAA9hkAAFsFAADAEAAAJRwAAIoHAADvEgAAVB4AALkJAAAeFQAAgwAAAOgLAABNFwAAsgIAABcOAAB8GQAA
| 4QQAAEYQAACrGwAAEAcAAHUSAADaHQAAPwkAAKQUAAAJAAAAbgsAANMWAAA4AgAAnQ0AAAIZAABnBAAAzA8AADEbAACWBgAA
| +xEAAGAdAADFCAAAKhQAAI8fAAD0CgAAWRYAAL4BAAAjDQAAiBgAAO0DAABSDwAAtxoAABwGAACBEQAA5hwAAEsIAACwEwAA
| FR8AAHoKAADfFQAARAEAAKkMAAAOGAAAcwMAANgOAAA9GgAAogUAAAcRAABsHAAA0QcAADYTAACbHgAAAAoAAGUVAADKAAAA
| LwwAAJQXAAD5AgAAXg4AAMMZAAAoBQAAjRAAAPIbAABXBwAAvBIAACEeAACGCQAA6xQAAFAAAAC1CwAAGhcAAH8CAADkDQAA
| SRkAAK4EAAATEAAAeBsAAN0GAABCEgAApx0AAAwJAABxFAAA1h8AADsLAACgFgAABQIAAGoNAADPGAAANAQAAJkPAAD+GgAA
| YwYAAMgRAAAtHQAAkggAAPcTAABcHwAAwQoAACYWAACLAQAA8AwAAFUYAAC6AwAAHw8AAIQaAADpBQAAThEAALMcAAAYCAAA
| fRMAAOIeAABHCgAArBUAABEBAAB2DAAA2xcAAEADAAClDgAAChoAAG8FAADUEAAAORwAAJ4HAAADEwAAaB4AAM0JAAAyFQAA
| lwAAAPwLAABhFwAAxgIAACsOAACQGQAA9QQAAFoQAAC/GwAAJAcAAIkSAADuHQAAUwkAALgUAAAdAAAAggsAAOcWAABMAgAA
| sQ0AABYZAAB7BAAA4A8AAEUbAACqBgAADxIAAHQdAADZCAAAPhQAAKMfAAAICwAAbRYAANIBAAA3DQAAnBgAAAEEAABmDwAA
| yxoAADAGAACVEQAA+hwAAF8IAADEEwAAKR8AAI4KAADzFQAAWAEAAL0MAAAiGAAAhwMAAOwOAABRGgAAtgUAABsRAACAHAAA
| 5QcAAEoTAACvHgAAFAoAAHkVAADeAAAAQwwAAKgXAAANAwAAcg4AANcZAAA8BQAA5hwAAEsIAACwEwAAFR8AAHoKAADfFQAA
| RAEAAKkMAAAOGAAAcwMAANgOAAA9GgAAogUAAAcRAABsHAAA0QcAADYTAACbHgAAAAoAAGUVAADKAAAALwwAAJQXAAD5AgAA
| Xg4AAMMZAAAoBQAAjRAAAPIbAABXBwAAvBIAACEeAACGCQAA6xQAAFAAAAC1CwAAGhcAAH8CAADkDQAASRkAAK4EAAATEAAA
| eBsAAN0GAABCEgAApx0AAAwJAABxFAAA1h8AADsLAACgFgAABQIAAGoNAADPGAAANAQAAJkPAAD+GgAAYwYAAMgRAAAtHQAA
| kggAAPcTAABcHwAAwQoAACYWAACLAQAA8AwAAFUYAAC6AwAAHw8AAIQaAADpBQAAThEAALMcAAAYCAAAfRMAAOIeAABHCgAA
| rBUAABEBAAB2DAAA2xcAAEADAAClDgAAChoAAG8FAADUEAAAORwAAJ4HAAADEwAAaB4AAM0JAAAyFQAAlwAAAPwLAABhFwAA
| xgIAACsOAACQGQAA9QQAAFoQAAC/GwAAJAcAAIkSAADuHQAAUwkAALgUAAAdAAAAggsAAOcWAABMAgAAsQ0AABYZAAB7BAAA
| 4A8AAEUbAACqBgAADxIAAHQdAADZCAAAPhQAAKMfAAAICwAAbRYAANIBAAA3DQAAnBgAAAEEAABmDwAAyxoAADAGAACVEQAA
| +hwAAF8IAADEEwAAKR8AAI4KAADzFQAAWAEAAL0MAAAiGAAAhwMAAOwOAABRGgAAtgUAABsRAACAHAAA5QcAAEoTAACvHgAA
| FAoAAHkVAADeAAAAQwwAAKgXAAANAwAAcg4AANcZAAA8BQAAoRAAAAYcAABrBwAA0BIAADUeAACaCQAA/xQAAGQAAADJCwAA
| LhcAAJMCAAD4DQAAXRkAAMIEAAAnEAAAjBsAAPEGAABWEgAAux0AACAJAACFFAAA6h8AAE8LAAC0FgAAGQIAAH4NAADjGAAA
| SAQAAK0PAAASGwAAdwYAANwRAABBHQAApggAAAsUAABwHwAA1QoAADoWAACfAQAABA0AAGkYAADOAwAAMw8AAJgaAAD9BQAA
| YhEAAMccAAAsCAAAkRMAAPYeAABbCgAAwBUAACUBAACKDAAA7xcAAFQDAAC5DgAAHhoAAIMFAADoEAAATRwAALIHAAAXEwAA
| fB4AAOEJAABGFQAAqwAAABAMAAB1FwAA2gIAAD8OAACkGQAACQUAAG4QAADTGwAAOAcAAJ0SAAACHgAAZwkAAMwUAAAxAAAA
| lgsAAPsWAABgAgAAxQ0AACoZAACPBAAA9A8AAFkbAAC+BgAAIxIAAIgdAADtCAAAUhQAALcfAAAcCwAAgRYAACsOAACQGQAA
| 9QQAAFoQAAC/GwAAJAcAAIkSAADuHQAAUwkAALgUAAAdAAAAggsAAOcWAABMAgAAsQ0AABYZAAB7BAAA4A8AAEUbAACqBgAA
| DxIAAHQdAADZCAAAPhQAAKMfAAAICwAAbRYAANIBAAA3DQAAnBgAAAEEAABmDwAAyxoAADAGAACVEQAA+hwAAF8IAADEEwAA
| KR8AAI4KAADzFQAAWAEAAL0MAAAiGAAAhwMAAOwOAABRGgAAtgUAABsRAACAHAAA5QcAAEoTAACvHgAAFAoAAHkVAADeAAAA
| QwwAAKgXAAANAwAAcg4AANcZAAA8BQAAoRAAAAYcAABrBwAA0BIAADUeAACaCQAA/xQAAGQAAADJCwAALhcAAJMCAAD4DQAA
| XRkAAMIEAAAnEAAAjBsAAPEGAABWEgAAux0AACAJAACFFAAA6h8AAE8LAAC0FgAAGQIAAH4NAADjGAAASAQAAK0PAAASGwAA
| dwYAANwRAABBHQAApggAAAsUAABwHwAA1QoAADoWAACfAQAABA0AAGkYAADOAwAAMw8AAJgaAAD9BQAAYhEAAMccAAAsCAAA
| kRMAAPYeAABbCgAAwBUAACUBAACKDAAA7xcAAFQDAAC5DgAAHhoAAIMFAADoEAAATRwAALIHAAAXEwAAfB4AAOEJAABGFQAA
| qwAAABAMAAB1FwAA2gIAAD8OAACkGQAACQUAAG4QAADTGwAAOAcAAJ0SAAACHgAAZwkAAMwUAAAxAAAAlgsAAPsWAABgAgAA
| xQ0AACoZAACPBAAA9A8AAFkbAAC+BgAAIxIAAIgdAADtCAAAUhQAALcfAAAcCwAAgRYAAOYBAABLDQAAsBgAABUEAAB6DwAA
| 3xoAAEQGAACpEQAADh0AAHMIAADYEwAAPR8AAKIKAAAHFgAAbAEAANEMAAA2GAAAmwMAAAAPAABlGgAAygUAAC8RAACUHAAA
| +QcAAF4TAADDHgAAKAoAAI0VAADyAAAAVwwAALwXAAAhAwAAhg4AAOsZAABQBQAAtRAAABocAAB/BwAA5BIAAEkeAACuCQAA
| ExUAAHgAAADdCwAAQhcAAKcCAAAMDgAAcRkAANYEAAA7EAAAoBsAAAUHAABqEgAAzx0AADQJAACZFAAA/h8AAGMLAADIFgAA
| LQIAAJINAAD3GAAAXAQAAMEPAAAmGwAAiwYAAPARAABVHQAAuggAAB8UAACEHwAA6QoAAE4WAACzAQAAGA0AAH0YAADiAwAA
| Rw8AAKwaAAARBgAAdhEAANscAABACAAApRMAAAofAABvCgAA1BUAADkBAACeDAAAAxgAAGgDAADNDgAAMhoAAJcFAAD8EAAA
| YRwAAMYHAABwHwAA1QoAADoWAACfAQAABA0AAGkYAADOAwAAMw8AAJgaAAD9BQAAYhEAAMccAAAsCAAAkRMAAPYeAABbCgAA
| wBUAACUBAACKDAAA7xcAAFQDAAC5DgAAHhoAAIMFAADoEAAATRwAALIHAAAXEwAAfB4AAOEJAABGFQAAqwAAABAMAAB1FwAA
| 2gIAAD8OAACkGQAACQUAAG4QAADTGwAAOAcAAJ0SAAACHgAAZwkAAMwUAAAxAAAAlgsAAPsWAABgAgAAxQ0AACoZAACPBAAA
| 9A8AAFkbAAC+BgAAIxIAAIgdAADtCAAAUhQAALcfAAAcCwAAgRYAAOYBAABLDQAAsBgAABUEAAB6DwAA3xoAAEQGAACpEQAA
| Dh0AAHMIAADYEwAAPR8AAKIKAAAHFgAAbAEAANEMAAA2GAAAmwMAAAAPAABlGgAAygUAAC8RAACUHAAA+QcAAF4TAADDHgAA
| KAoAAI0VAADyAAAAVwwAALwXAAAhAwAAhg4AAOsZAABQBQAAtRAAABocAAB/BwAA5BIAAEkeAACuCQAAExUAAHgAAADdCwAA
| QhcAAKcCAAAMDgAAcRkAANYEAAA7EAAAoBsAAAUHAABqEgAAzx0AADQJAACZFAAA/h8AAGMLAADIFgAALQIAAJINAAD3GAAA
| XAQAAMEPAAAmGwAAiwYAAPARAABVHQAAuggAAB8UAACEHwAA6QoAAE4WAACzAQAAGA0AAH0YAADiAwAARw8AAKwaAAARBgAA
| dhEAANscAABACAAApRMAAAofAABvCgAA1BUAADkBAACeDAAAAxgAAGgDAADNDgAAMhoAAJcFAAD8EAAAYRwAAMYHAAArEwAA
| kB4AAPUJAABaFQAAvwAAACQMAACJFwAA7gIAAFMOAAC4GQAAHQUAAIIQAADnGwAATAcAALESAAAWHgAAewkAAOAUAABFAAAA
| qgsAAA8XAAB0AgAA2Q0AAD4ZAACjBAAACBAAAG0bAADSBgAANxIAAJwdAAABCQAAZhQAAMsfAAAwCwAAlRYAAPoBAABfDQAA
| xBgAACkEAACODwAA8xoAAFgGAAC9EQAAIh0AAIcIAADsEwAAUR8AALYKAAAbFgAAgAEAAOUMAABKGAAArwMAABQPAAB5GgAA
| 3gUAAEMRAACoHAAADQgAAHITAADXHgAAPAoAAKEVAAAGAQAAawwAANAXAAA1AwAAmg4AAP8ZAABkBQAAyRAAAC4cAACTBwAA
| +BIAAF0eAADCCQAAJxUAAIwAAADxCwAAVhcAALsCAAAgDgAAhRkAAOoEAABPEAAAtBsAABkHAAB+EgAA4x0AAEgJAACtFAAA
| EgAAAHcLAADcFgAAQQIAAKYNAAALGQAAtRAAABocAAB/BwAA5BIAAEkeAACuCQAAExUAAHgAAADdCwAAQhcAAKcCAAAMDgAA
| cRkAANYEAAA7EAAAoBsAAAUHAABqEgAAzx0AADQJAACZFAAA/h8AAGMLAADIFgAALQIAAJINAAD3GAAAXAQAAMEPAAAmGwAA
| iwYAAPARAABVHQAAuggAAB8UAACEHwAA6QoAAE4WAACzAQAAGA0AAH0YAADiAwAARw8AAKwaAAARBgAAdhEAANscAABACAAA
| pRMAAAofAABvCgAA1BUAADkBAACeDAAAAxgAAGgDAADNDgAAMhoAAJcFAAD8EAAAYRwAAMYHAAArEwAAkB4AAPUJAABaFQAA
| vwAAACQMAACJFwAA7gIAAFMOAAC4GQAAHQUAAIIQAADnGwAATAcAALESAAAWHgAAewkAAOAUAABFAAAAqgsAAA8XAAB0AgAA
| 2Q0AAD4ZAACjBAAACBAAAG0bAADSBgAANxIAAJwdAAABCQAAZhQAAMsfAAAwCwAAlRYAAPoBAABfDQAAxBgAACkEAACODwAA
| 8xoAAFgGAAC9EQAAIh0AAIcIAADsEwAAUR8AALYKAAAbFgAAgAEAAOUMAABKGAAArwMAABQPAAB5GgAA3gUAAEMRAACoHAAA
| DQgAAHITAADXHgAAPAoAAKEVAAAGAQAAawwAANAXAAA1AwAAmg4AAP8ZAABkBQAAyRAAAC4cAACTBwAA+BIAAF0eAADCCQAA
| JxUAAIwAAADxCwAAVhcAALsCAAAgDgAAhRkAAOoEAABPEAAAtBsAABkHAAB+EgAA4x0AAEgJAACtFAAAEgAAAHcLAADcFgAA
| QQIAAKYNAAALGQAAcAQAANUPAAA6GwAAnwYAAAQSAABpHQAAzggAADMUAACYHwAA/QoAAGIWAADHAQAALA0AAJEYAAD2AwAA
| Ww8AAMAaAAAlBgAAihEAAO8cAABUCAAAuRMAAB4fAACDCgAA6BUAAE0BAACyDAAAFxgAAHwDAADhDgAARhoAAKsFAAAQEQAA
| dRwAANoHAAA/EwAApB4AAAkKAABuFQAA0wAAADgMAACdFwAAAgMAAGcOAADMGQAAMQUAAJYQAAD7GwAAYAcAAMUSAAAqHgAA
| jwkAAPQUAABZAAAAvgsAACMXAACIAgAA7Q0AAFIZAAC3BAAAHBAAAIEbAADmBgAASxIAALAdAAAVCQAAehQAAN8fAABECwAA
| qRYAAA4CAABzDQAA2BgAAD0EAACiDwAABxsAAGwGAADREQAANh0AAJsIAAAAFAAAZR8AAMoKAAAvFgAAlAEAAPkMAABeGAAA
| wwMAACgPAACNGgAA8gUAAFcRAAC8HAAAIQgAAIYTAADrHgAAUAoAAPoBAABfDQAAxBgAACkEAACODwAA8xoAAFgGAAC9EQAA
| Ih0AAIcIAADsEwAAUR8AALYKAAAbFgAAgAEAAOUMAABKGAAArwMAABQPAAB5GgAA3gUAAEMRAACoHAAADQgAAHITAADXHgAA
| PAoAAKEVAAAGAQAAawwAANAXAAA1AwAAmg4AAP8ZAABkBQAAyRAAAC4cAACTBwAA+BIAAF0eAADCCQAAJxUAAIwAAADxCwAA
| VhcAALsCAAAgDgAAhRkAAOoEAABPEAAAtBsAABkHAAB+EgAA4x0AAEgJAACtFAAAEgAAAHcLAADcFgAAQQIAAKYNAAALGQAA
| cAQAANUPAAA6GwAAnwYAAAQSAABpHQAAzggAADMUAACYHwAA/QoAAGIWAADHAQAALA0AAJEYAAD2AwAAWw8AAMAaAAAlBgAA
| ihEAAO8cAABUCAAAuRMAAB4fAACDCgAA6BUAAE0BAACyDAAAFxgAAHwDAADhDgAARhoAAKsFAAAQEQAAdRwAANoHAAA/EwAA
| pB4AAAkKAABuFQAA0wAAADgMAACdFwAAAgMAAGcOAADMGQAAMQUAAJYQAAD7GwAAYAcAAMUSAAAqHgAAjwkAAPQUAABZAAAA
| vgsAACMXAACIAgAA7Q0AAFIZAAC3BAAAHBAAAIEbAADmBgAASxIAALAdAAAVCQAAehQAAN8fAABECwAAqRYAAA4CAABzDQAA
| 2BgAAD0EAACiDwAABxsAAGwGAADREQAANh0AAJsIAAAAFAAAZR8AAMoKAAAvFgAAlAEAAPkMAABeGAAAwwMAACgPAACNGgAA
| 8gUAAFcRAAC8HAAAIQgAAIYTAADrHgAAUAoAALUVAAAaAQAAfwwAAOQXAABJAwAArg4AABMaAAB4BQAA3RAAAEIcAACnBwAA
| DBMAAHEeAADWCQAAOxUAAKAAAAAFDAAAahcAAM8CAAA0DgAAmRkAAP4EAABjEAAAyBsAAC0HAACSEgAA9x0AAFwJAADBFAAA
| JgAAAIsLAADwFgAAVQIAALoNAAAfGQAAhAQAAOkPAABOGwAAswYAABgSAAB9HQAA4ggAAEcUAACsHwAAEQsAAHYWAADbAQAA
| QA0AAKUYAAAKBAAAbw8AANQaAAA5BgAAnhEAAAMdAABoCAAAzRMAADIfAACXCgAA/BUAAGEBAADGDAAAKxgAAJADAAD1DgAA
| WhoAAL8FAAAkEQAAiRwAAO4HAABTEwAAuB4AAB0KAACCFQAA5wAAAEwMAACxFwAAFgMAAHsOAADgGQAARQUAAKoQAAAPHAAA
| dAcAANkSAAA+HgAAowkAAAgVAABtAAAA0gsAADcXAACcAgAAAQ4AAGYZAADLBAAAMBAAAJUbAAA/EwAApB4AAAkKAABuFQAA
| 0wAAADgMAACdFwAAAgMAAGcOAADMGQAAMQUAAJYQAAD7GwAAYAcAAMUSAAAqHgAAjwkAAPQUAABZAAAAvgsAACMXAACIAgAA
| 7Q0AAFIZAAC3BAAAHBAAAIEbAADmBgAASxIAALAdAAAVCQAAehQAAN8fAABECwAAqRYAAA4CAABzDQAA2BgAAD0EAACiDwAA
| BxsAAGwGAADREQAANh0AAJsIAAAAFAAAZR8AAMoKAAAvFgAAlAEAAPkMAABeGAAAwwMAACgPAACNGgAA8gUAAFcRAAC8HAAA
| IQgAAIYTAADrHgAAUAoAALUVAAAaAQAAfwwAAOQXAABJAwAArg4AABMaAAB4BQAA3RAAAEIcAACnBwAADBMAAHEeAADWCQAA
| OxUAAKAAAAAFDAAAahcAAM8CAAA0DgAAmRkAAP4EAABjEAAAyBsAAC0HAACSEgAA9x0AAFwJAADBFAAAJgAAAIsLAADwFgAA
| VQIAALoNAAAfGQAAhAQAAOkPAABOGwAAswYAABgSAAB9HQAA4ggAAEcUAACsHwAAEQsAAHYWAADbAQAAQA0AAKUYAAAKBAAA
| bw8AANQaAAA5BgAAnhEAAAMdAABoCAAAzRMAADIfAACXCgAA/BUAAGEBAADGDAAAKxgAAJADAAD1DgAAWhoAAL8FAAAkEQAA
| iRwAAO4HAABTEwAAuB4AAB0KAACCFQAA5wAAAEwMAACxFwAAFgMAAHsOAADgGQAARQUAAKoQAAAPHAAAdAcAANkSAAA+HgAA
| owkAAAgVAABtAAAA0gsAADcXAACcAgAAAQ4AAGYZAADLBAAAMBAAAJUbAAD6BgAAXxIAAMQdAAApCQAAjhQAAPMfAABYCwAA
| vRYAACICAACHDQAA7BgAAFEEAAC2DwAAGxsAAIAGAADlEQAASh0AAK8IAAAUFAAAeR8AAN4KAABDFgAAqAEAAA0NAAByGAAA
| 1wMAADwPAAChGgAABgYAAGsRAADQHAAANQgAAJoTAAD/HgAAZAoAAMkVAAAuAQAAkwwAAPgXAABdAwAAwg4AACcaAACMBQAA
| 8RAAAFYcAAC7BwAAIBMAAIUeAADqCQAATxUAALQAAAAZDAAAfhcAAOMCAABIDgAArRkAABIFAAB3EAAA3BsAAEEHAACmEgAA
| Cx4AAHAJAADVFAAAOgAAAJ8LAAAEFwAAaQIAAM4NAAAzGQAAmAQAAP0PAABiGwAAxwYAACwSAACRHQAA9ggAAFsUAADAHwAA
| JQsAAIoWAADvAQAAVA0AALkYAAAeBAAAgw8AAOgaAABNBgAAshEAABcdAAB8CAAA4RMAAEYfAACrCgAAEBYAAHUBAADaDAAA
| hAQAAOkPAABOGwAAswYAABgSAAB9HQAA4ggAAEcUAACsHwAAEQsAAHYWAADbAQAAQA0AAKUYAAAKBAAAbw8AANQaAAA5BgAA
| nhEAAAMdAABoCAAAzRMAADIfAACXCgAA/BUAAGEBAADGDAAAKxgAAJADAAD1DgAAWhoAAL8FAAAkEQAAiRwAAO4HAABTEwAA
| uB4AAB0KAACCFQAA5wAAAEwMAACxFwAAFgMAAHsOAADgGQAARQUAAKoQAAAPHAAAdAcAANkSAAA+HgAAowkAAAgVAABtAAAA
| 0gsAADcXAACcAgAAAQ4AAGYZAADLBAAAMBAAAJUbAAD6BgAAXxIAAMQdAAApCQAAjhQAAPMfAABYCwAAvRYAACICAACHDQAA
| 7BgAAFEEAAC2DwAAGxsAAIAGAADlEQAASh0AAK8IAAAUFAAAeR8AAN4KAABDFgAAqAEAAA0NAAByGAAA1wMAADwPAAChGgAA
| BgYAAGsRAADQHAAANQgAAJoTAAD/HgAAZAoAAMkVAAAuAQAAkwwAAPgXAABdAwAAwg4AACcaAACMBQAA8RAAAFYcAAC7BwAA
| IBMAAIUeAADqCQAATxUAALQAAAAZDAAAfhcAAOMCAABIDgAArRkAABIFAAB3EAAA3BsAAEEHAACmEgAACx4AAHAJAADVFAAA
| OgAAAJ8LAAAEFwAAaQIAAM4NAAAzGQAAmAQAAP0PAABiGwAAxwYAACwSAACRHQAA9ggAAFsUAADAHwAAJQsAAIoWAADvAQAA
| VA0AALkYAAAeBAAAgw8AAOgaAABNBgAAshEAABcdAAB8CAAA4RMAAEYfAACrCgAAEBYAAHUBAADaDAAAPxgAAKQDAAAJDwAA
| bhoAANMFAAA4EQAAnRwAAAIIAABnEwAAzB4AADEKAACWFQAA+wAAAGAMAADFFwAAKgMAAI8OAAD0GQAAWQUAAL4QAAAjHAAA
| iAcAAO0SAABSHgAAtwkAABwVAACBAAAA5gsAAEsXAACwAgAAFQ4AAHoZAADfBAAARBAAAKkbAAAOBwAAcxIAANgdAAA9CQAA
| ohQAAAcAAABsCwAA0RYAADYCAACbDQAAABkAAGUEAADKDwAALxsAAJQGAAD5EQAAXh0AAMMIAAAoFAAAjR8AAPIKAABXFgAA
| vAEAACENAACGGAAA6wMAAFAPAAC1GgAAGgYAAH8RAADkHAAASQgAAK4TAAATHwAAeAoAAN0VAABCAQAApwwAAAwYAABxAwAA
| 1g4AADsaAACgBQAABREAAGocAADPBwAANBMAAJkeAAD+CQAAYxUAAMgAAAAtDAAAkhcAAPcCAABcDgAAwRkAACYFAACLEAAA
| 8BsAAFUHAAC6EgAAHx4AAMkVAAAuAQAAkwwAAPgXAABdAwAAwg4AACcaAACMBQAA8RAAAFYcAAC7BwAAIBMAAIUeAADqCQAA
| TxUAALQAAAAZDAAAfhcAAOMCAABIDgAArRkAABIFAAB3EAAA3BsAAEEHAACmEgAACx4AAHAJAADVFAAAOgAAAJ8LAAAEFwAA
| aQIAAM4NAAAzGQAAmAQAAP0PAABiGwAAxwYAACwSAACRHQAA9ggAAFsUAADAHwAAJQsAAIoWAADvAQAAVA0AALkYAAAeBAAA
| gw8AAOgaAABNBgAAshEAABcdAAB8CAAA4RMAAEYfAACrCgAAEBYAAHUBAADaDAAAPxgAAKQDAAAJDwAAbhoAANMFAAA4EQAA
| nRwAAAIIAABnEwAAzB4AADEKAACWFQAA+wAAAGAMAADFFwAAKgMAAI8OAAD0GQAAWQUAAL4QAAAjHAAAiAcAAO0SAABSHgAA
| twkAABwVAACBAAAA5gsAAEsXAACwAgAAFQ4AAHoZAADfBAAARBAAAKkbAAAOBwAAcxIAANgdAAA9CQAAohQAAAcAAABsCwAA
| 0RYAADYCAACbDQAAABkAAGUEAADKDwAALxsAAJQGAAD5EQAAXh0AAMMIAAAoFAAAjR8AAPIKAABXFgAAvAEAACENAACGGAAA
| 6wMAAFAPAAC1GgAAGgYAAH8RAADkHAAASQgAAK4TAAATHwAAeAoAAN0VAABCAQAApwwAAAwYAABxAwAA1g4AADsaAACgBQAA
| BREAAGocAADPBwAANBMAAJkeAAD+CQAAYxUAAMgAAAAtDAAAkhcAAPcCAABcDgAAwRkAACYFAACLEAAA8BsAAFUHAAC6EgAA
| Hx4AAIQJAADpFAAATgAAALMLAAAYFwAAfQIAAOINAABHGQAArAQAABEQAAB2GwAA2wYAAEASAAClHQAACgkAAG8UAADUHwAA
| OQsAAJ4WAAADAgAAaA0AAM0YAAAyBAAAlw8AAPwaAABhBgAAxhEAACsdAACQCAAA9RMAAFofAAC/CgAAJBYAAIkBAADuDAAA
| UxgAALgDAAAdDwAAghoAAOcFAABMEQAAsRwAABYIAAB7EwAA4B4AAEUKAACqFQAADwEAAHQMAADZFwAAPgMAAKMOAAAIGgAA
| bQUAANIQAAA3HAAAnAcAAAETAABmHgAAywkAADAVAACVAAAA+gsAAF8XAADEAgAAKQ4AAI4ZAADzBAAAWBAAAL0bAAAiBwAA
| hxIAAOwdAABRCQAAthQAABsAAACACwAA5RYAAEoCAACvDQAAFBkAAHkEAADeDwAAQxsAAKgGAAANEgAAch0AANcIAAA8FAAA
| oR8AAAYLAABrFgAA0AEAADUNAACaGAAA/wMAAGQPAAAOBwAAcxIAANgdAAA9CQAAohQAAAcAAABsCwAA0RYAADYCAACbDQAA
| ABkAAGUEAADKDwAALxsAAJQGAAD5EQAAXh0AAMMIAAAoFAAAjR8AAPIKAABXFgAAvAEAACENAACGGAAA6wMAAFAPAAC1GgAA
| GgYAAH8RAADkHAAASQgAAK4TAAATHwAAeAoAAN0VAABCAQAApwwAAAwYAABxAwAA1g4AADsaAACgBQAABREAAGocAADPBwAA
| NBMAAJkeAAD+CQAAYxUAAMgAAAAtDAAAkhcAAPcCAABcDgAAwRkAACYFAACLEAAA8BsAAFUHAAC6EgAAHx4AAIQJAADpFAAA
| TgAAALMLAAAYFwAAfQIAAOINAABHGQAArAQAABEQAAB2GwAA2wYAAEASAAClHQAACgkAAG8UAADUHwAAOQsAAJ4WAAADAgAA
| aA0AAM0YAAAyBAAAlw8AAPwaAABhBgAAxhEAACsdAACQCAAA9RMAAFofAAC/CgAAJBYAAIkBAADuDAAAUxgAALgDAAAdDwAA
| ghoAAOcFAABMEQAAsRwAABYIAAB7EwAA4B4AAEUKAACqFQAADwEAAHQMAADZFwAAPgMAAKMOAAAIGgAAbQUAANIQAAA3HAAA
| nAcAAAETAABmHgAAywkAADAVAACVAAAA+gsAAF8XAADEAgAAKQ4AAI4ZAADzBAAAWBAAAL0bAAAiBwAAhxIAAOwdAABRCQAA
| thQAABsAAACACwAA5RYAAEoCAACvDQAAFBkAAHkEAADeDwAAQxsAAKgGAAANEgAAch0AANcIAAA8FAAAoR8AAAYLAABrFgAA
| 0AEAADUNAACaGAAA/wMAAGQPAADJGgAALgYAAJMRAAD4HAAAXQgAAMITAAAnHwAAjAoAAPEVAABWAQAAuwwAACAYAACFAwAA
| 6g4AAE8aAAC0BQAAGREAAH4cAADjBwAASBMAAK0eAAASCgAAdxUAANwAAABBDAAAphcAAAsDAABwDgAA1RkAADoFAACfEAAA
| BBwAAGkHAADOEgAAMx4AAJgJAAD9FAAAYgAAAMcLAAAsFwAAkQIAAPYNAABbGQAAwAQAACUQAACKGwAA7wYAAFQSAAC5HQAA
| HgkAAIMUAADoHwAATQsAALIWAAAXAgAAfA0AAOEYAABGBAAAqw8AABAbAAB1BgAA2hEAAD8dAACkCAAACRQAAG4fAADTCgAA
| OBYAAJ0BAAACDQAAZxgAAMwDAAAxDwAAlhoAAPsFAABgEQAAxRwAACoIAACPEwAA9B4AAFkKAAC+FQAAIwEAAIgMAADtFwAA
| UgMAALcOAAAcGgAAgQUAAOYQAABLHAAAsAcAABUTAAB6HgAA3wkAAEQVAACpAAAAUxgAALgDAAAdDwAAghoAAOcFAABMEQAA
| sRwAABYIAAB7EwAA4B4AAEUKAACqFQAADwEAAHQMAADZFwAAPgMAAKMOAAAIGgAAbQUAANIQAAA3HAAAnAcAAAETAABmHgAA
| ywkAADAVAACVAAAA+gsAAF8XAADEAgAAKQ4AAI4ZAADzBAAAWBAAAL0bAAAiBwAAhxIAAOwdAABRCQAAthQAABsAAACACwAA
| 5RYAAEoCAACvDQAAFBkAAHkEAADeDwAAQxsAAKgGAAANEgAAch0AANcIAAA8FAAAoR8AAAYLAABrFgAA0AEAADUNAACaGAAA
| /wMAAGQPAADJGgAALgYAAJMRAAD4HAAAXQgAAMITAAAnHwAAjAoAAPEVAABWAQAAuwwAACAYAACFAwAA6g4AAE8aAAC0BQAA
| GREAAH4cAADjBwAASBMAAK0eAAASCgAAdxUAANwAAABBDAAAphcAAAsDAABwDgAA1RkAADoFAACfEAAABBwAAGkHAADOEgAA
| Mx4AAJgJAAD9FAAAYgAAAMcLAAAsFwAAkQIAAPYNAABbGQAAwAQAACUQAACKGwAA7wYAAFQSAAC5HQAAHgkAAIMUAADoHwAA
| TQsAALIWAAAXAgAAfA0AAOEYAABGBAAAqw8AABAbAAB1BgAA2hEAAD8dAACkCAAACRQAAG4fAADTCgAAOBYAAJ0BAAACDQAA
| ZxgAAMwDAAAxDwAAlhoAAPsFAABgEQAAxRwAACoIAACPEwAA9B4AAFkKAAC+FQAAIwEAAIgMAADtFwAAUgMAALcOAAAcGgAA
| gQUAAOYQAABLHAAAsAcAABUTAAB6HgAA3wkAAEQVAACpAAAADgwAAHMXAADYAgAAPQ4AAKIZAAAHBQAAbBAAANEbAAA2BwAA
| mxIAAAAeAABlCQAAyhQAAC8AAACUCwAA+RYAAF4CAADDDQAAKBkAAI0EAADyDwAAVxsAALwGAAAhEgAAhh0AAOsIAABQFAAA
| tR8AABoLAAB/FgAA5AEAAEkNAACuGAAAEwQAAHgPAADdGgAAQgYAAKcRAAAMHQAAcQgAANYTAAA7HwAAoAoAAAUWAABqAQAA
| zwwAADQYAACZAwAA/g4AAGMaAADIBQAALREAAJIcAAD3BwAAXBMAAMEeAAAmCgAAixUAAPAAAABVDAAAuhcAAB8DAACEDgAA
| 6RkAAE4FAACzEAAAGBwAAH0HAADiEgAARx4AAKwJAAARFQAAdgAAANsLAABAFwAApQIAAAoOAABvGQAA1AQAADkQAACeGwAA
| AwcAAGgSAADNHQAAMgkAAJcUAAD8HwAAYQsAAMYWAAArAgAAkA0AAPUYAABaBAAAvw8AACQbAACJBgAA7hEAAJgJAAD9FAAA
| YgAAAMcLAAAsFwAAkQIAAPYNAABbGQAAwAQAACUQAACKGwAA7wYAAFQSAAC5HQAAHgkAAIMUAADoHwAATQsAALIWAAAXAgAA
| fA0AAOEYAABGBAAAqw8AABAbAAB1BgAA2hEAAD8dAACkCAAACRQAAG4fAADTCgAAOBYAAJ0BAAACDQAAZxgAAMwDAAAxDwAA
| lhoAAPsFAABgEQAAxRwAACoIAACPEwAA9B4AAFkKAAC+FQAAIwEAAIgMAADtFwAAUgMAALcOAAAcGgAAgQUAAOYQAABLHAAA
| sAcAABUTAAB6HgAA3wkAAEQVAACpAAAADgwAAHMXAADYAgAAPQ4AAKIZAAAHBQAAbBAAANEbAAA2BwAAmxIAAAAeAABlCQAA
| yhQAAC8AAACUCwAA+RYAAF4CAADDDQAAKBkAAI0EAADyDwAAVxsAALwGAAAhEgAAhh0AAOsIAABQFAAAtR8AABoLAAB/FgAA
| 5AEAAEkNAACuGAAAEwQAAHgPAADdGgAAQgYAAKcRAAAMHQAAcQgAANYTAAA7HwAAoAoAAAUWAABqAQAAzwwAADQYAACZAwAA
| /g4AAGMaAADIBQAALREAAJIcAAD3BwAAXBMAAMEeAAAmCgAAixUAAPAAAABVDAAAuhcAAB8DAACEDgAA6RkAAE4FAACzEAAA
| GBwAAH0HAADiEgAARx4AAKwJAAARFQAAdgAAANsLAABAFwAApQIAAAoOAABvGQAA1AQAADkQAACeGwAAAwcAAGgSAADNHQAA
| MgkAAJcUAAD8HwAAYQsAAMYWAAArAgAAkA0AAPUYAABaBAAAvw8AACQbAACJBgAA7hEAAFMdAAC4CAAAHRQAAIIfAADnCgAA
| TBYAALEBAAAWDQAAexgAAOADAABFDwAAqhoAAA8GAAB0EQAA2RwAAD4IAACjEwAACB8AAG0KAADSFQAANwEAAJwMAAABGAAA
| ZgMAAMsOAAAwGgAAlQUAAPoQAABfHAAAxAcAACkTAACOHgAA8wkAAFgVAAC9AAAAIgwAAIcXAADsAgAAUQ4AALYZAAAbBQAA
| gBAAAOUbAABKBwAArxIAABQeAAB5CQAA3hQAAEMAAACoCwAADRcAAHICAADXDQAAPBkAAKEEAAAGEAAAaxsAANAGAAA1EgAA
| mh0AAP8IAABkFAAAyR8AAC4LAACTFgAA+AEAAF0NAADCGAAAJwQAAIwPAADxGgAAVgYAALsRAAAgHQAAhQgAAOoTAABPHwAA
| tAoAABkWAAB+AQAA4wwAAEgYAACtAwAAEg8AAHcaAADcBQAAQREAAKYcAAALCAAAcBMAANUeAAA6CgAAnxUAAAQBAABpDAAA
| zhcAADMDAADdGgAAQgYAAKcRAAAMHQAAcQgAANYTAAA7HwAAoAoAAAUWAABqAQAAzwwAADQYAACZAwAA/g4AAGMaAADIBQAA
| LREAAJIcAAD3BwAAXBMAAMEeAAAmCgAAixUAAPAAAABVDAAAuhcAAB8DAACEDgAA6RkAAE4FAACzEAAAGBwAAH0HAADiEgAA
| Rx4AAKwJAAARFQAAdgAAANsLAABAFwAApQIAAAoOAABvGQAA1AQAADkQAACeGwAAAwcAAGgSAADNHQAAMgkAAJcUAAD8HwAA
| YQsAAMYWAAArAgAAkA0AAPUYAABaBAAAvw8AACQbAACJBgAA7hEAAFMdAAC4CAAAHRQAAIIfAADnCgAATBYAALEBAAAWDQAA
| exgAAOADAABFDwAAqhoAAA8GAAB0EQAA2RwAAD4IAACjEwAACB8AAG0KAADSFQAANwEAAJwMAAABGAAAZgMAAMsOAAAwGgAA
| lQUAAPoQAABfHAAAxAcAACkTAACOHgAA8wkAAFgVAAC9AAAAIgwAAIcXAADsAgAAUQ4AALYZAAAbBQAAgBAAAOUbAABKBwAA
| rxIAABQeAAB5CQAA3hQAAEMAAACoCwAADRcAAHICAADXDQAAPBkAAKEEAAAGEAAAaxsAANAGAAA1EgAAmh0AAP8IAABkFAAA
| yR8AAC4LAACTFgAA+AEAAF0NAADCGAAAJwQAAIwPAADxGgAAVgYAALsRAAAgHQAAhQgAAOoTAABPHwAAtAoAABkWAAB+AQAA
| 4wwAAEgYAACtAwAAEg8AAHcaAADcBQAAQREAAKYcAAALCAAAcBMAANUeAAA6CgAAnxUAAAQBAABpDAAAzhcAADMDAACYDgAA
| /RkAAGIFAADHEAAALBwAAJEHAAD2EgAAWx4AAMAJAAAlFQAAigAAAO8LAABUFwAAuQIAAB4OAACDGQAA6AQAAE0QAACyGwAA
| FwcAAHwSAADhHQAARgkAAKsUAAAQAAAAdQsAANoWAAA/AgAApA0AAAkZAABuBAAA0w8AADgbAACdBgAAAhIAAGcdAADMCAAA
| MRQAAJYfAAD7CgAAYBYAAMUBAAAqDQAAjxgAAPQDAABZDwAAvhoAACMGAACIEQAA7RwAAFIIAAC3EwAAHB8AAIEKAADmFQAA
| SwEAALAMAAAVGAAAegMAAN8OAABEGgAAqQUAAA4RAABzHAAA2AcAAD0TAACiHgAABwoAAGwVAADRAAAANgwAAJsXAAAAAwAA
| ZQ4AAMoZAAAvBQAAlBAAAPkbAABeBwAAwxIAACgeAACNCQAA8hQAAFcAAAC8CwAAIRcAAIYCAADrDQAAUBkAALUEAAAaEAAA
| fxsAAOQGAABJEgAArh0AABMJAAB4FAAAIgwAAIcXAADsAgAAUQ4AALYZAAAbBQAAgBAAAOUbAABKBwAArxIAABQeAAB5CQAA
| 3hQAAEMAAACoCwAADRcAAHICAADXDQAAPBkAAKEEAAAGEAAAaxsAANAGAAA1EgAAmh0AAP8IAABkFAAAyR8AAC4LAACTFgAA
| +AEAAF0NAADCGAAAJwQAAIwPAADxGgAAVgYAALsRAAAgHQAAhQgAAOoTAABPHwAAtAoAABkWAAB+AQAA4wwAAEgYAACtAwAA
| Eg8AAHcaAADcBQAAQREAAKYcAAALCAAAcBMAANUeAAA6CgAAnxUAAAQBAABpDAAAzhcAADMDAACYDgAA/RkAAGIFAADHEAAA
| LBwAAJEHAAD2EgAAWx4AAMAJAAAlFQAAigAAAO8LAABUFwAAuQIAAB4OAACDGQAA6AQAAE0QAACyGwAAFwcAAHwSAADhHQAA
| RgkAAKsUAAAQAAAAdQsAANoWAAA/AgAApA0AAAkZAABuBAAA0w8AADgbAACdBgAAAhIAAGcdAADMCAAAMRQAAJYfAAD7CgAA
| YBYAAMUBAAAqDQAAjxgAAPQDAABZDwAAvhoAACMGAACIEQAA7RwAAFIIAAC3EwAAHB8AAIEKAADmFQAASwEAALAMAAAVGAAA
| egMAAN8OAABEGgAAqQUAAA4RAABzHAAA2AcAAD0TAACiHgAABwoAAGwVAADRAAAANgwAAJsXAAAAAwAAZQ4AAMoZAAAvBQAA
| lBAAAPkbAABeBwAAwxIAACgeAACNCQAA8hQAAFcAAAC8CwAAIRcAAIYCAADrDQAAUBkAALUEAAAaEAAAfxsAAOQGAABJEgAA
| rh0AABMJAAB4FAAA3R8AAEILAACnFgAADAIAAHENAADWGAAAOwQAAKAPAAAFGwAAagYAAM8RAAA0HQAAmQgAAP4TAABjHwAA
| yAoAAC0WAACSAQAA9wwAAFwYAADBAwAAJg8AAIsaAADwBQAAVREAALocAAAfCAAAhBMAAOkeAABOCgAAsxUAABgBAAB9DAAA
| 4hcAAEcDAACsDgAAERoAAHYFAADbEAAAQBwAAKUHAAAKEwAAbx4AANQJAAA5FQAAngAAAAMMAABoFwAAzQIAADIOAACXGQAA
| /AQAAGEQAADGGwAAKwcAAJASAAD1HQAAWgkAAL8UAAAkAAAAiQsAAO4WAABTAgAAuA0AAB0ZAACCBAAA5w8AAEwbAACxBgAA
| FhIAAHsdAADgCAAARRQAAKofAAAPCwAAdBYAANkBAAA+DQAAoxgAAAgEAABtDwAA0hoAADcGAACcEQAAAR0AAGYIAADLEwAA
| MB8AAJUKAAD6FQAAXwEAAMQMAAApGAAAjgMAAPMOAABYGgAAvQUAAGcdAADMCAAAMRQAAJYfAAD7CgAAYBYAAMUBAAAqDQAA
| jxgAAPQDAABZDwAAvhoAACMGAACIEQAA7RwAAFIIAAC3EwAAHB8AAIEKAADmFQAASwEAALAMAAAVGAAAegMAAN8OAABEGgAA
| qQUAAA4RAABzHAAA2AcAAD0TAACiHgAABwoAAGwVAADRAAAANgwAAJsXAAAAAwAAZQ4AAMoZAAAvBQAAlBAAAPkbAABeBwAA
| wxIAACgeAACNCQAA8hQAAFcAAAC8CwAAIRcAAIYCAADrDQAAUBkAALUEAAAaEAAAfxsAAOQGAABJEgAArh0AABMJAAB4FAAA
| 3R8AAEILAACnFgAADAIAAHENAADWGAAAOwQAAKAPAAAFGwAAagYAAM8RAAA0HQAAmQgAAP4TAABjHwAAyAoAAC0WAACSAQAA
| 9wwAAFwYAADBAwAAJg8AAIsaAADwBQAAVREAALocAAAfCAAAhBMAAOkeAABOCgAAsxUAABgBAAB9DAAA4hcAAEcDAACsDgAA
| ERoAAHYFAADbEAAAQBwAAKUHAAAKEwAAbx4AANQJAAA5FQAAngAAAAMMAABoFwAAzQIAADIOAACXGQAA/AQAAGEQAADGGwAA
| KwcAAJASAAD1HQAAWgkAAL8UAAAkAAAAiQsAAO4WAABTAgAAuA0AAB0ZAACCBAAA5w8AAEwbAACxBgAAFhIAAHsdAADgCAAA
| RRQAAKofAAAPCwAAdBYAANkBAAA+DQAAoxgAAAgEAABtDwAA0hoAADcGAACcEQAAAR0AAGYIAADLEwAAMB8AAJUKAAD6FQAA
| XwEAAMQMAAApGAAAjgMAAPMOAABYGgAAvQUAACIRAACHHAAA7AcAAFETAAC2HgAAGwoAAIAVAADlAAAASgwAAK8XAAAUAwAA
| eQ4AAN4ZAABDBQAAqBAAAA0cAAByBwAA1xIAADweAAChCQAABhUAAGsAAADQCwAANRcAAJoCAAD/DQAAZBkAAMkEAAAuEAAA
| kxsAAPgGAABdEgAAwh0AACcJAACMFAAA8R8AAFYLAAC7FgAAIAIAAIUNAADqGAAATwQAALQPAAAZGwAAfgYAAOMRAABIHQAA
| rQgAABIUAAB3HwAA3AoAAEEWAACmAQAACw0AAHAYAADVAwAAOg8AAJ8aAAAEBgAAaREAAM4cAAAzCAAAmBMAAP0eAABiCgAA
| xxUAACwBAACRDAAA9hcAAFsDAADADgAAJRoAAIoFAADvEAAAVBwAALkHAAAeEwAAgx4AAOgJAABNFQAAsgAAABcMAAB8FwAA
| 4QIAAEYOAACrGQAAEAUAAHUQAADaGwAAPwcAAKQSAAAJHgAAbgkAANMUAAA4AAAAnQsAAAIXAACsDgAAERoAAHYFAADbEAAA
| QBwAAKUHAAAKEwAAbx4AANQJAAA5FQAAngAAAAMMAABoFwAAzQIAADIOAACXGQAA/AQAAGEQAADGGwAAKwcAAJASAAD1HQAA
| WgkAAL8UAAAkAAAAiQsAAO4WAABTAgAAuA0AAB0ZAACCBAAA5w8AAEwbAACxBgAAFhIAAHsdAADgCAAARRQAAKofAAAPCwAA
| dBYAANkBAAA+DQAAoxgAAAgEAABtDwAA0hoAADcGAACcEQAAAR0AAGYIAADLEwAAMB8AAJUKAAD6FQAAXwEAAMQMAAApGAAA
| jgMAAPMOAABYGgAAvQUAACIRAACHHAAA7AcAAFETAAC2HgAAGwoAAIAVAADlAAAASgwAAK8XAAAUAwAAeQ4AAN4ZAABDBQAA
| qBAAAA0cAAByBwAA1xIAADweAAChCQAABhUAAGsAAADQCwAANRcAAJoCAAD/DQAAZBkAAMkEAAAuEAAAkxsAAPgGAABdEgAA
| wh0AACcJAACMFAAA8R8AAFYLAAC7FgAAIAIAAIUNAADqGAAATwQAALQPAAAZGwAAfgYAAOMRAABIHQAArQgAABIUAAB3HwAA
| 3AoAAEEWAACmAQAACw0AAHAYAADVAwAAOg8AAJ8aAAAEBgAAaREAAM4cAAAzCAAAmBMAAP0eAABiCgAAxxUAACwBAACRDAAA
| 9hcAAFsDAADADgAAJRoAAIoFAADvEAAAVBwAALkHAAAeEwAAgx4AAOgJAABNFQAAsgAAABcMAAB8FwAA4QIAAEYOAACrGQAA
| EAUAAHUQAADaGwAAPwcAAKQSAAAJHgAAbgkAANMUAAA4AAAAnQsAAAIXAABnAgAAzA0AADEZAACWBAAA+w8AAGAbAADFBgAA
| KhIAAI8dAAD0CAAAWRQAAL4fAAAjCwAAiBYAAO0BAABSDQAAtxgAABwEAACBDwAA5hoAAEsGAACwEQAAFR0AAHoIAADfEwAA
| RB8AAKkKAAAOFgAAcwEAANgMAAA9GAAAogMAAAcPAABsGgAA0QUAADYRAACbHAAAAAgAAGUTAADKHgAALwoAAJQVAAD5AAAA
| XgwAAMMXAAAoAwAAjQ4AAPIZAABXBQAAvBAAACEcAACGBwAA6xIAAFAeAAC1CQAAGhUAAH8AAADkCwAASRcAAK4CAAATDgAA
| eBkAAN0EAABCEAAApxsAAAwHAABxEgAA1h0AADsJAACgFAAABQAAAGoLAADPFgAANAIAAJkNAAD+GAAAYwQAAMgPAAAtGwAA
| kgYAAPcRAABcHQAAwQgAACYUAACLHwAA8AoAAFUWAAC6AQAAHw0AAIQYAADpAwAATg8AALMaAAAYBgAAfREAAOIcAABHCAAA
| 8R8AAFYLAAC7FgAAIAIAAIUNAADqGAAATwQAALQPAAAZGwAAfgYAAOMRAABIHQAArQgAABIUAAB3HwAA3AoAAEEWAACmAQAA
| Cw0AAHAYAADVAwAAOg8AAJ8aAAAEBgAAaREAAM4cAAAzCAAAmBMAAP0eAABiCgAAxxUAACwBAACRDAAA9hcAAFsDAADADgAA
| JRoAAIoFAADvEAAAVBwAALkHAAAeEwAAgx4AAOgJAABNFQAAsgAAABcMAAB8FwAA4QIAAEYOAACrGQAAEAUAAHUQAADaGwAA
| PwcAAKQSAAAJHgAAbgkAANMUAAA4AAAAnQsAAAIXAABnAgAAzA0AADEZAACWBAAA+w8AAGAbAADFBgAAKhIAAI8dAAD0CAAA
| WRQAAL4fAAAjCwAAiBYAAO0BAABSDQAAtxgAABwEAACBDwAA5hoAAEsGAACwEQAAFR0AAHoIAADfEwAARB8AAKkKAAAOFgAA
| cwEAANgMAAA9GAAAogMAAAcPAABsGgAA0QUAADYRAACbHAAAAAgAAGUTAADKHgAALwoAAJQVAAD5AAAAXgwAAMMXAAAoAwAA
| jQ4AAPIZAABXBQAAvBAAACEcAACGBwAA6xIAAFAeAAC1CQAAGhUAAH8AAADkCwAASRcAAK4CAAATDgAAeBkAAN0EAABCEAAA
| pxsAAAwHAABxEgAA1h0AADsJAACgFAAABQAAAGoLAADPFgAANAIAAJkNAAD+GAAAYwQAAMgPAAAtGwAAkgYAAPcRAABcHQAA
| wQgAACYUAACLHwAA8AoAAFUWAAC6AQAAHw0AAIQYAADpAwAATg8AALMaAAAYBgAAfREAAOIcAABHCAAArBMAABEfAAB2CgAA
| 2xUAAEABAAClDAAAChgAAG8DAADUDgAAORoAAJ4FAAADEQAAaBwAAM0HAAAyEwAAlx4AAPwJAABhFQAAxgAAACsMAACQFwAA
| 9QIAAFoOAAC/GQAAJAUAAIkQAADuGwAAUwcAALgSAAAdHgAAggkAAOcUAABMAAAAsQsAABYXAAB7AgAA4A0AAEUZAACqBAAA
| DxAAAHQbAADZBgAAPhIAAKMdAAAICQAAbRQAANIfAAA3CwAAnBYAAAECAABmDQAAyxgAADAEAACVDwAA+hoAAF8GAADEEQAA
| KR0AAI4IAADzEwAAWB8AAL0KAAAiFgAAhwEAAOwMAABRGAAAtgMAABsPAACAGgAA5QUAAEoRAACvHAAAFAgAAHkTAADeHgAA
| QwoAAKgVAAANAQAAcgwAANcXAAA8AwAAoQ4AAAYaAABrBQAA0BAAADUcAACaBwAA/xIAAGQeAADJCQAALhUAAJMAAAD4CwAA
| XRcAAMICAAAnDgAAjBkAADYRAACbHAAAAAgAAGUTAADKHgAALwoAAJQVAAD5AAAAXgwAAMMXAAAoAwAAjQ4AAPIZAABXBQAA
| vBAAACEcAACGBwAA6xIAAFAeAAC1CQAAGhUAAH8AAADkCwAASRcAAK4CAAATDgAAeBkAAN0EAABCEAAApxsAAAwHAABxEgAA
| 1h0AADsJAACgFAAABQAAAGoLAADPFgAANAIAAJkNAAD+GAAAYwQAAMgPAAAtGwAAkgYAAPcRAABcHQAAwQgAACYUAACLHwAA
| 8AoAAFUWAAC6AQAAHw0AAIQYAADpAwAATg8AALMaAAAYBgAAfREAAOIcAABHCAAArBMAABEfAAB2CgAA2xUAAEABAAClDAAA
| ChgAAG8DAADUDgAAORoAAJ4FAAADEQAAaBwAAM0HAAAyEwAAlx4AAPwJAABhFQAAxgAAACsMAACQFwAA9QIAAFoOAAC/GQAA
| JAUAAIkQAADuGwAAUwcAALgSAAAdHgAAggkAAOcUAABMAAAAsQsAABYXAAB7AgAA4A0AAEUZAACqBAAADxAAAHQbAADZBgAA
| PhIAAKMdAAAICQAAbRQAANIfAAA3CwAAnBYAAAECAABmDQAAyxgAADAEAACVDwAA+hoAAF8GAADEEQAAKR0AAI4IAADzEwAA
| WB8AAL0KAAAiFgAAhwEAAOwMAABRGAAAtgMAABsPAACAGgAA5QUAAEoRAACvHAAAFAgAAHkTAADeHgAAQwoAAKgVAAANAQAA
| cgwAANcXAAA8AwAAoQ4AAAYaAABrBQAA0BAAADUcAACaBwAA/xIAAGQeAADJCQAALhUAAJMAAAD4CwAAXRcAAMICAAAnDgAA
| jBkAAPEEAABWEAAAuxsAACAHAACFEgAA6h0AAE8JAAC0FAAAGQAAAH4LAADjFgAASAIAAK0NAAASGQAAdwQAANwPAABBGwAA
| pgYAAAsSAABwHQAA1QgAADoUAACfHwAABAsAAGkWAADOAQAAMw0AAJgYAAD9AwAAYg8AAMcaAAAsBgAAkREAAPYcAABbCAAA
| wBMAACUfAACKCgAA7xUAAFQBAAC5DAAAHhgAAIMDAADoDgAATRoAALIFAAAXEQAAfBwAAOEHAABGEwAAqx4AABAKAAB1FQAA
| 2gAAAD8MAACkFwAACQMAAG4OAADTGQAAOAUAAJ0QAAACHAAAZwcAAMwSAAAxHgAAlgkAAPsUAABgAAAAxQsAACoXAACPAgAA
| 9A0AAFkZAAC+BAAAIxAAAIgbAADtBgAAUhIAALcdAAAcCQAAgRQAAOYfAABLCwAAsBYAABUCAAB6DQAA3xgAAEQEAACpDwAA
| DhsAAHMGAADYEQAAPR0AAKIIAAAHFAAAbB8AANEKAAB7AgAA4A0AAEUZAACqBAAADxAAAHQbAADZBgAAPhIAAKMdAAAICQAA
| bRQAANIfAAA3CwAAnBYAAAECAABmDQAAyxgAADAEAACVDwAA+hoAAF8GAADEEQAAKR0AAI4IAADzEwAAWB8AAL0KAAAiFgAA
| hwEAAOwMAABRGAAAtgMAABsPAACAGgAA5QUAAEoRAACvHAAAFAgAAHkTAADeHgAAQwoAAKgVAAANAQAAcgwAANcXAAA8AwAA
| oQ4AAAYaAABrBQAA0BAAADUcAACaBwAA/xIAAGQeAADJCQAALhUAAJMAAAD4CwAAXRcAAMICAAAnDgAAjBkAAPEEAABWEAAA
| uxsAACAHAACFEgAA6h0AAE8JAAC0FAAAGQAAAH4LAADjFgAASAIAAK0NAAASGQAAdwQAANwPAABBGwAApgYAAAsSAABwHQAA
| 1QgAADoUAACfHwAABAsAAGkWAADOAQAAMw0AAJgYAAD9AwAAYg8AAMcaAAAsBgAAkREAAPYcAABbCAAAwBMAACUfAACKCgAA
| 7xUAAFQBAAC5DAAAHhgAAIMDAADoDgAATRoAALIFAAAXEQAAfBwAAOEHAABGEwAAqx4AABAKAAB1FQAA2gAAAD8MAACkFwAA
| CQMAAG4OAADTGQAAOAUAAJ0QAAACHAAAZwcAAMwSAAAxHgAAlgkAAPsUAABgAAAAxQsAACoXAACPAgAA9A0AAFkZAAC+BAAA
| IxAAAIgbAADtBgAAUhIAALcdAAAcCQAAgRQAAOYfAABLCwAAsBYAABUCAAB6DQAA3xgAAEQEAACpDwAADhsAAHMGAADYEQAA
| PR0AAKIIAAAHFAAAbB8AANEKAAA2FgAAmwEAAAANAABlGAAAygMAAC8PAACUGgAA+QUAAF4RAADDHAAAKAgAAI0TAADyHgAA
| VwoAALwVAAAhAQAAhgwAAOsXAABQAwAAtQ4AABoaAAB/BQAA5BAAAEkcAACuBwAAExMAAHgeAADdCQAAQhUAAKcAAAAMDAAA
| cRcAANYCAAA7DgAAoBkAAAUFAABqEAAAzxsAADQHAACZEgAA/h0AAGMJAADIFAAALQAAAJILAAD3FgAAXAIAAMENAAAmGQAA
| iwQAAPAPAABVGwAAugYAAB8SAACEHQAA6QgAAE4UAACzHwAAGAsAAH0WAADiAQAARw0AAKwYAAARBAAAdg8AANsaAABABgAA
| pREAAAodAABvCAAA1BMAADkfAACeCgAAAxYAAGgBAADNDAAAMhgAAJcDAAD8DgAAYRoAAMYFAAArEQAAkBwAAPUHAABaEwAA
| vx4AACQKAACJFQAA7gAAAFMMAAC4FwAAHQMAAIIOAADnGQAATAUAALEQAAAWHAAAwBMAACUfAACKCgAA7xUAAFQBAAC5DAAA
| HhgAAIMDAADoDgAATRoAALIFAAAXEQAAfBwAAOEHAABGEwAAqx4AABAKAAB1FQAA2gAAAD8MAACkFwAACQMAAG4OAADTGQAA
| OAUAAJ0QAAACHAAAZwcAAMwSAAAxHgAAlgkAAPsUAABgAAAAxQsAACoXAACPAgAA9A0AAFkZAAC+BAAAIxAAAIgbAADtBgAA
| UhIAALcdAAAcCQAAgRQAAOYfAABLCwAAsBYAABUCAAB6DQAA3xgAAEQEAACpDwAADhsAAHMGAADYEQAAPR0AAKIIAAAHFAAA
| bB8AANEKAAA2FgAAmwEAAAANAABlGAAAygMAAC8PAACUGgAA+QUAAF4RAADDHAAAKAgAAI0TAADyHgAAVwoAALwVAAAhAQAA
| hgwAAOsXAABQAwAAtQ4AABoaAAB/BQAA5BAAAEkcAACuBwAAExMAAHgeAADdCQAAQhUAAKcAAAAMDAAAcRcAANYCAAA7DgAA
| oBkAAAUFAABqEAAAzxsAADQHAACZEgAA/h0AAGMJAADIFAAALQAAAJILAAD3FgAAXAIAAMENAAAmGQAAiwQAAPAPAABVGwAA
| ugYAAB8SAACEHQAA6QgAAE4UAACzHwAAGAsAAH0WAADiAQAARw0AAKwYAAARBAAAdg8AANsaAABABgAApREAAAodAABvCAAA
| 1BMAADkfAACeCgAAAxYAAGgBAADNDAAAMhgAAJcDAAD8DgAAYRoAAMYFAAArEQAAkBwAAPUHAABaEwAAvx4AACQKAACJFQAA
| 7gAAAFMMAAC4FwAAHQMAAIIOAADnGQAATAUAALEQAAAWHAAAewcAAOASAABFHgAAqgkAAA8VAAB0AAAA2QsAAD4XAACjAgAA
| CA4AAG0ZAADSBAAANxAAAJwbAAABBwAAZhIAAMsdAAAwCQAAlRQAAPofAABfCwAAxBYAACkCAACODQAA8xgAAFgEAAC9DwAA
| IhsAAIcGAADsEQAAUR0AALYIAAAbFAAAgB8AAOUKAABKFgAArwEAABQNAAB5GAAA3gMAAEMPAACoGgAADQYAAHIRAADXHAAA
| PAgAAKETAAAGHwAAawoAANAVAAA1AQAAmgwAAP8XAABkAwAAyQ4AAC4aAACTBQAA+BAAAF0cAADCBwAAJxMAAIweAADxCQAA
| VhUAALsAAAAgDAAAhRcAAOoCAABPDgAAtBkAABkFAAB+EAAA4xsAAEgHAACtEgAAEh4AAHcJAADcFAAAQQAAAKYLAAALFwAA
| cAIAANUNAAA6GQAAnwQAAAQQAABpGwAAzgYAADMSAACYHQAA/QgAAGIUAADHHwAALAsAAJEWAAD2AQAAWw0AAAUFAABqEAAA
| zxsAADQHAACZEgAA/h0AAGMJAADIFAAALQAAAJILAAD3FgAAXAIAAMENAAAmGQAAiwQAAPAPAABVGwAAugYAAB8SAACEHQAA
| 6QgAAE4UAACzHwAAGAsAAH0WAADiAQAARw0AAKwYAAARBAAAdg8AANsaAABABgAApREAAAodAABvCAAA1BMAADkfAACeCgAA
| AxYAAGgBAADNDAAAMhgAAJcDAAD8DgAAYRoAAMYFAAArEQAAkBwAAPUHAABaEwAAvx4AACQKAACJFQAA7gAAAFMMAAC4FwAA
| HQMAAIIOAADnGQAATAUAALEQAAAWHAAAewcAAOASAABFHgAAqgkAAA8VAAB0AAAA2QsAAD4XAACjAgAACA4AAG0ZAADSBAAA
| NxAAAJwbAAABBwAAZhIAAMsdAAAwCQAAlRQAAPofAABfCwAAxBYAACkCAACODQAA8xgAAFgEAAC9DwAAIhsAAIcGAADsEQAA
| UR0AALYIAAAbFAAAgB8AAOUKAABKFgAArwEAABQNAAB5GAAA3gMAAEMPAACoGgAADQYAAHIRAADXHAAAPAgAAKETAAAGHwAA
| awoAANAVAAA1AQAAmgwAAP8XAABkAwAAyQ4AAC4aAACTBQAA+BAAAF0cAADCBwAAJxMAAIweAADxCQAAVhUAALsAAAAgDAAA
| hRcAAOoCAABPDgAAtBkAABkFAAB+EAAA4xsAAEgHAACtEgAAEh4AAHcJAADcFAAAQQAAAKYLAAALFwAAcAIAANUNAAA6GQAA
| nwQAAAQQAABpGwAAzgYAADMSAACYHQAA/QgAAGIUAADHHwAALAsAAJEWAAD2AQAAWw0AAMAYAAAlBAAAig8AAO8aAABUBgAA
| uREAAB4dAACDCAAA6BMAAE0fAACyCgAAFxYAAHwBAADhDAAARhgAAKsDAAAQDwAAdRoAANoFAAA/EQAApBwAAAkIAABuEwAA
| 0x4AADgKAACdFQAAAgEAAGcMAADMFwAAMQMAAJYOAAD7GQAAYAUAAMUQAAAqHAAAjwcAAPQSAABZHgAAvgkAACMVAACIAAAA
| 7QsAAFIXAAC3AgAAHA4AAIEZAADmBAAASxAAALAbAAAVBwAAehIAAN8dAABECQAAqRQAAA4AAABzCwAA2BYAAD0CAACiDQAA
| BxkAAGwEAADRDwAANhsAAJsGAAAAEgAAZR0AAMoIAAAvFAAAlB8AAPkKAABeFgAAwwEAACgNAACNGAAA8gMAAFcPAAC8GgAA
| IQYAAIYRAADrHAAAUAgAALUTAAAaHwAAfwoAAOQVAABJAQAArgwAABMYAAB4AwAA3Q4AAEIaAACnBQAADBEAAHEcAADWBwAA
| OxMAAKAeAABKFgAArwEAABQNAAB5GAAA3gMAAEMPAACoGgAADQYAAHIRAADXHAAAPAgAAKETAAAGHwAAawoAANAVAAA1AQAA
| mgwAAP8XAABkAwAAyQ4AAC4aAACTBQAA+BAAAF0cAADCBwAAJxMAAIweAADxCQAAVhUAALsAAAAgDAAAhRcAAOoCAABPDgAA
| tBkAABkFAAB+EAAA4xsAAEgHAACtEgAAEh4AAHcJAADcFAAAQQAAAKYLAAALFwAAcAIAANUNAAA6GQAAnwQAAAQQAABpGwAA
| zgYAADMSAACYHQAA/QgAAGIUAADHHwAALAsAAJEWAAD2AQAAWw0AAMAYAAAlBAAAig8AAO8aAABUBgAAuREAAB4dAACDCAAA
| 6BMAAE0fAACyCgAAFxYAAHwBAADhDAAARhgAAKsDAAAQDwAAdRoAANoFAAA/EQAApBwAAAkIAABuEwAA0x4AADgKAACdFQAA
| AgEAAGcMAADMFwAAMQMAAJYOAAD7GQAAYAUAAMUQAAAqHAAAjwcAAPQSAABZHgAAvgkAACMVAACIAAAA7QsAAFIXAAC3AgAA
| HA4AAIEZAADmBAAASxAAALAbAAAVBwAAehIAAN8dAABECQAAqRQAAA4AAABzCwAA2BYAAD0CAACiDQAABxkAAGwEAADRDwAA
| NhsAAJsGAAAAEgAAZR0AAMoIAAAvFAAAlB8AAPkKAABeFgAAwwEAACgNAACNGAAA8gMAAFcPAAC8GgAAIQYAAIYRAADrHAAA
| UAgAALUTAAAaHwAAfwoAAOQVAABJAQAArgwAABMYAAB4AwAA3Q4AAEIaAACnBQAADBEAAHEcAADWBwAAOxMAAKAeAAAFCgAA
| ahUAAM8AAAA0DAAAmRcAAP4CAABjDgAAyBkAAC0FAACSEAAA9xsAAFwHAADBEgAAJh4AAIsJAADwFAAAVQAAALoLAAAfFwAA
| hAIAAOkNAABOGQAAswQAABgQAAB9GwAA4gYAAEcSAACsHQAAEQkAAHYUAADbHwAAQAsAAKUWAAAKAgAAbw0AANQYAAA5BAAA
| ng8AAAMbAABoBgAAzREAADIdAACXCAAA/BMAAGEfAADGCgAAKxYAAJABAAD1DAAAWhgAAL8DAAAkDwAAiRoAAO4FAABTEQAA
| uBwAAB0IAACCEwAA5x4AAEwKAACxFQAAFgEAAHsMAADgFwAARQMAAKoOAAAPGgAAdAUAANkQAAA+HAAAowcAAAgTAABtHgAA
| 0gkAADcVAACcAAAAAQwAAGYXAADLAgAAMA4AAJUZAAD6BAAAXxAAAMQbAAApBwAAjhIAAPMdAABYCQAAvRQAACIAAACHCwAA
| 7BYAAFECAAC2DQAAGxkAAIAEAADlDwAAjwcAAPQSAABZHgAAvgkAACMVAACIAAAA7QsAAFIXAAC3AgAAHA4AAIEZAADmBAAA
| SxAAALAbAAAVBwAAehIAAN8dAABECQAAqRQAAA4AAABzCwAA2BYAAD0CAACiDQAABxkAAGwEAADRDwAANhsAAJsGAAAAEgAA
| ZR0AAMoIAAAvFAAAlB8AAPkKAABeFgAAwwEAACgNAACNGAAA8gMAAFcPAAC8GgAAIQYAAIYRAADrHAAAUAgAALUTAAAaHwAA
| fwoAAOQVAABJAQAArgwAABMYAAB4AwAA3Q4AAEIaAACnBQAADBEAAHEcAADWBwAAOxMAAKAeAAAFCgAAahUAAM8AAAA0DAAA
| mRcAAP4CAABjDgAAyBkAAC0FAACSEAAA9xsAAFwHAADBEgAAJh4AAIsJAADwFAAAVQAAALoLAAAfFwAAhAIAAOkNAABOGQAA
| swQAABgQAAB9GwAA4gYAAEcSAACsHQAAEQkAAHYUAADbHwAAQAsAAKUWAAAKAgAAbw0AANQYAAA5BAAAng8AAAMbAABoBgAA
| zREAADIdAACXCAAA/BMAAGEfAADGCgAAKxYAAJABAAD1DAAAWhgAAL8DAAAkDwAAiRoAAO4FAABTEQAAuBwAAB0IAACCEwAA
| 5x4AAEwKAACxFQAAFgEAAHsMAADgFwAARQMAAKoOAAAPGgAAdAUAANkQAAA+HAAAowcAAAgTAABtHgAA0gkAADcVAACcAAAA
| AQwAAGYXAADLAgAAMA4AAJUZAAD6BAAAXxAAAMQbAAApBwAAjhIAAPMdAABYCQAAvRQAACIAAACHCwAA7BYAAFECAAC2DQAA
| GxkAAIAEAADlDwAAShsAAK8GAAAUEgAAeR0AAN4IAABDFAAAqB8AAA0LAAByFgAA1wEAADwNAAChGAAABgQAAGsPAADQGgAA
| NQYAAJoRAAD/HAAAZAgAAMkTAAAuHwAAkwoAAPgVAABdAQAAwgwAACcYAACMAwAA8Q4AAFYaAAC7BQAAIBEAAIUcAADqBwAA
| TxMAALQeAAAZCgAAfhUAAOMAAABIDAAArRcAABIDAAB3DgAA3BkAAEEFAACmEAAACxwAAHAHAADVEgAAOh4AAJ8JAAAEFQAA
| aQAAAM4LAAAzFwAAmAIAAP0NAABiGQAAxwQAACwQAACRGwAA9gYAAFsSAADAHQAAJQkAAIoUAADvHwAAVAsAALkWAAAeAgAA
| gw0AAOgYAABNBAAAsg8AABcbAAB8BgAA4REAAEYdAACrCAAAEBQAAHUfAADaCgAAPxYAAKQBAAAJDQAAbhgAANMDAAA4DwAA
| nRoAAAIGAABnEQAAzBwAADEIAACWEwAA+x4AAGAKAADFFQAAKgEAANQYAAA5BAAAng8AAAMbAABoBgAAzREAADIdAACXCAAA
| /BMAAGEfAADGCgAAKxYAAJABAAD1DAAAWhgAAL8DAAAkDwAAiRoAAO4FAABTEQAAuBwAAB0IAACCEwAA5x4AAEwKAACxFQAA
| FgEAAHsMAADgFwAARQMAAKoOAAAPGgAAdAUAANkQAAA+HAAAowcAAAgTAABtHgAA0gkAADcVAACcAAAAAQwAAGYXAADLAgAA
| MA4AAJUZAAD6BAAAXxAAAMQbAAApBwAAjhIAAPMdAABYCQAAvRQAACIAAACHCwAA7BYAAFECAAC2DQAAGxkAAIAEAADlDwAA
| ShsAAK8GAAAUEgAAeR0AAN4IAABDFAAAqB8AAA0LAAByFgAA1wEAADwNAAChGAAABgQAAGsPAADQGgAANQYAAJoRAAD/HAAA
| ZAgAAMkTAAAuHwAAkwoAAPgVAABdAQAAwgwAACcYAACMAwAA8Q4AAFYaAAC7BQAAIBEAAIUcAADqBwAATxMAALQeAAAZCgAA
| fhUAAOMAAABIDAAArRcAABIDAAB3DgAA3BkAAEEFAACmEAAACxwAAHAHAADVEgAAOh4AAJ8JAAAEFQAAaQAAAM4LAAAzFwAA
| mAIAAP0NAABiGQAAxwQAACwQAACRGwAA9gYAAFsSAADAHQAAJQkAAIoUAADvHwAAVAsAALkWAAAeAgAAgw0AAOgYAABNBAAA
| sg8AABcbAAB8BgAA4REAAEYdAACrCAAAEBQAAHUfAADaCgAAPxYAAKQBAAAJDQAAbhgAANMDAAA4DwAAnRoAAAIGAABnEQAA
| zBwAADEIAACWEwAA+x4AAGAKAADFFQAAKgEAAI8MAAD0FwAAWQMAAL4OAAAjGgAAiAUAAO0QAABSHAAAtwcAABwTAACBHgAA
| 5gkAAEsVAACwAAAAFQwAAHoXAADfAgAARA4AAKkZAAAOBQAAcxAAANgbAAA9BwAAohIAAAceAABsCQAA0RQAADYAAACbCwAA
| ABcAAGUCAADKDQAALxkAAJQEAAD5DwAAXhsAAMMGAAAoEgAAjR0AAPIIAABXFAAAvB8AACELAACGFgAA6wEAAFANAAC1GAAA
| GgQAAH8PAADkGgAASQYAAK4RAAATHQAAeAgAAN0TAABCHwAApwoAAAwWAABxAQAA1gwAADsYAACgAwAABQ8AAGoaAADPBQAA
| NBEAAJkcAAD+BwAAYxMAAMgeAAAtCgAAkhUAAPcAAABcDAAAwRcAACYDAACLDgAA8BkAAFUFAAC6EAAAHxwAAIQHAADpEgAA
| Th4AALMJAAAYFQAAfQAAAOILAABHFwAArAIAABEOAAB2GQAA2wQAAEAQAAClGwAACgcAAG8SAAAZCgAAfhUAAOMAAABIDAAA
| rRcAABIDAAB3DgAA3BkAAEEFAACmEAAACxwAAHAHAADVEgAAOh4AAJ8JAAAEFQAAaQAAAM4LAAAzFwAAmAIAAP0NAABiGQAA
| xwQAACwQAACRGwAA9gYAAFsSAADAHQAAJQkAAIoUAADvHwAAVAsAALkWAAAeAgAAgw0AAOgYAABNBAAAsg8AABcbAAB8BgAA
| 4REAAEYdAACrCAAAEBQAAHUfAADaCgAAPxYAAKQBAAAJDQAAbhgAANMDAAA4DwAAnRoAAAIGAABnEQAAzBwAADEIAACWEwAA
| +x4AAGAKAADFFQAAKgEAAI8MAAD0FwAAWQMAAL4OAAAjGgAAiAUAAO0QAABSHAAAtwcAABwTAACBHgAA5gkAAEsVAACwAAAA
| FQwAAHoXAADfAgAARA4AAKkZAAAOBQAAcxAAANgbAAA9BwAAohIAAAceAABsCQAA0RQAADYAAACbCwAAABcAAGUCAADKDQAA
| LxkAAJQEAAD5DwAAXhsAAMMGAAAoEgAAjR0AAPIIAABXFAAAvB8AACELAACGFgAA6wEAAFANAAC1GAAAGgQAAH8PAADkGgAA
| SQYAAK4RAAATHQAAeAgAAN0TAABCHwAApwoAAAwWAABxAQAA1gwAADsYAACgAwAABQ8AAGoaAADPBQAANBEAAJkcAAD+BwAA
| YxMAAMgeAAAtCgAAkhUAAPcAAABcDAAAwRcAACYDAACLDgAA8BkAAFUFAAC6EAAAHxwAAIQHAADpEgAATh4AALMJAAAYFQAA
| fQAAAOILAABHFwAArAIAABEOAAB2GQAA2wQAAEAQAAClGwAACgcAAG8SAADUHQAAOQkAAJ4UAAADAAAAaAsAAM0WAAAyAgAA
| lw0AAPwYAABhBAAAxg8AACsbAACQBgAA9REAAFodAAC/CAAAJBQAAIkfAADuCgAAUxYAALgBAAAdDQAAghgAAOcDAABMDwAA
| sRoAABYGAAB7EQAA4BwAAEUIAACqEwAADx8AAHQKAADZFQAAPgEAAKMMAAAIGAAAbQMAANIOAAA3GgAAnAUAAAERAABmHAAA
| ywcAADATAACVHgAA+gkAAF8VAADEAAAAKQwAAI4XAADzAgAAWA4AAL0ZAAAiBQAAhxAAAOwbAABRBwAAthIAABseAACACQAA
| 5RQAAEoAAACvCwAAFBcAAHkCAADeDQAAQxkAAKgEAAANEAAAchsAANcGAAA8EgAAoR0AAAYJAABrFAAA0B8AADULAACaFgAA
| /wEAAGQNAADJGAAALgQAAJMPAAD4GgAAXQYAAMIRAAAnHQAAjAgAAPETAABWHwAAuwoAACAWAACFAQAA6gwAAE8YAAC0AwAA
| XhsAAMMGAAAoEgAAjR0AAPIIAABXFAAAvB8AACELAACGFgAA6wEAAFANAAC1GAAAGgQAAH8PAADkGgAASQYAAK4RAAATHQAA
| eAgAAN0TAABCHwAApwoAAAwWAABxAQAA1gwAADsYAACgAwAABQ8AAGoaAADPBQAANBEAAJkcAAD+BwAAYxMAAMgeAAAtCgAA
| khUAAPcAAABcDAAAwRcAACYDAACLDgAA8BkAAFUFAAC6EAAAHxwAAIQHAADpEgAATh4AALMJAAAYFQAAfQAAAOILAABHFwAA
| rAIAABEOAAB2GQAA2wQAAEAQAAClGwAACgcAAG8SAADUHQAAOQkAAJ4UAAADAAAAaAsAAM0WAAAyAgAAlw0AAPwYAABhBAAA
| xg8AACsbAACQBgAA9REAAFodAAC/CAAAJBQAAIkfAADuCgAAUxYAALgBAAAdDQAAghgAAOcDAABMDwAAsRoAABYGAAB7EQAA
| 4BwAAEUIAACqEwAADx8AAHQKAADZFQAAPgEAAKMMAAAIGAAAbQMAANIOAAA3GgAAnAUAAAERAABmHAAAywcAADATAACVHgAA
| +gkAAF8VAADEAAAAKQwAAI4XAADzAgAAWA4AAL0ZAAAiBQAAhxAAAOwbAABRBwAAthIAABseAACACQAA5RQAAEoAAACvCwAA
| FBcAAHkCAADeDQAAQxkAAKgEAAANEAAAchsAANcGAAA8EgAAoR0AAAYJAABrFAAA0B8AADULAACaFgAA/wEAAGQNAADJGAAA
| LgQAAJMPAAD4GgAAXQYAAMIRAAAnHQAAjAgAAPETAABWHwAAuwoAACAWAACFAQAA6gwAAE8YAAC0AwAAGQ8AAH4aAADjBQAA
| SBEAAK0cAAASCAAAdxMAANweAABBCgAAphUAAAsBAABwDAAA1RcAADoDAACfDgAABBoAAGkFAADOEAAAMxwAAJgHAAD9EgAA
| Yh4AAMcJAAAsFQAAkQAAAPYLAABbFwAAwAIAACUOAACKGQAA7wQAAFQQAAC5GwAAHgcAAIMSAADoHQAATQkAALIUAAAXAAAA
| fAsAAOEWAABGAgAAqw0AABAZAAB1BAAA2g8AAD8bAACkBgAACRIAAG4dAADTCAAAOBQAAJ0fAAACCwAAZxYAAMwBAAAxDQAA
| lhgAAPsDAABgDwAAxRoAACoGAACPEQAA9BwAAFkIAAC+EwAAIx8AAIgKAADtFQAAUgEAALcMAAAcGAAAgQMAAOYOAABLGgAA
| sAUAABURAAB6HAAA3wcAAEQTAACpHgAADgoAAHMVAADYAAAAPQwAAKIXAAAHAwAAbA4AANEZAAA2BQAAmxAAAAAcAABlBwAA
| yhIAAC8eAACUCQAA+RQAAKMMAAAIGAAAbQMAANIOAAA3GgAAnAUAAAERAABmHAAAywcAADATAACVHgAA+gkAAF8VAADEAAAA
| KQwAAI4XAADzAgAAWA4AAL0ZAAAiBQAAhxAAAOwbAABRBwAAthIAABseAACACQAA5RQAAEoAAACvCwAAFBcAAHkCAADeDQAA
| QxkAAKgEAAANEAAAchsAANcGAAA8EgAAoR0AAAYJAABrFAAA0B8AADULAACaFgAA/wEAAGQNAADJGAAALgQAAJMPAAD4GgAA
| XQYAAMIRAAAnHQAAjAgAAPETAABWHwAAuwoAACAWAACFAQAA6gwAAE8YAAC0AwAAGQ8AAH4aAADjBQAASBEAAK0cAAASCAAA
| dxMAANweAABBCgAAphUAAAsBAABwDAAA1RcAADoDAACfDgAABBoAAGkFAADOEAAAMxwAAJgHAAD9EgAAYh4AAMcJAAAsFQAA
| kQAAAPYLAABbFwAAwAIAACUOAACKGQAA7wQAAFQQAAC5GwAAHgcAAIMSAADoHQAATQkAALIUAAAXAAAAfAsAAOEWAABGAgAA
| qw0AABAZAAB1BAAA2g8AAD8bAACkBgAACRIAAG4dAADTCAAAOBQAAJ0fAAACCwAAZxYAAMwBAAAxDQAAlhgAAPsDAABgDwAA
| xRoAACoGAACPEQAA9BwAAFkIAAC+EwAAIx8AAIgKAADtFQAAUgEAALcMAAAcGAAAgQMAAOYOAABLGgAAsAUAABURAAB6HAAA
| 3wcAAEQTAACpHgAADgoAAHMVAADYAAAAPQwAAKIXAAAHAwAAbA4AANEZAAA2BQAAmxAAAAAcAABlBwAAyhIAAC8eAACUCQAA
| +RQAAF4AAADDCwAAKBcAAI0CAADyDQAAVxkAALwEAAAhEAAAhhsAAOsGAABQEgAAtR0AABoJAAB/FAAA5B8AAEkLAACuFgAA
| EwIAAHgNAADdGAAAQgQAAKcPAAAMGwAAcQYAANYRAAA7HQAAoAgAAAUUAABqHwAAzwoAADQWAACZAQAA/gwAAGMYAADIAwAA
| LQ8AAJIaAAD3BQAAXBEAAMEcAAAmCAAAixMAAPAeAABVCgAAuhUAAB8BAACEDAAA6RcAAE4DAACzDgAAGBoAAH0FAADiEAAA
| RxwAAKwHAAAREwAAdh4AANsJAABAFQAApQAAAAoMAABvFwAA1AIAADkOAACeGQAAAwUAAGgQAADNGwAAMgcAAJcSAAD8HQAA
| YQkAAMYUAAArAAAAkAsAAPUWAABaAgAAvw0AACQZAACJBAAA7g8AAFMbAAC4BgAAHRIAAIIdAADnCAAATBQAALEfAAAWCwAA
| exYAAOABAABFDQAAqhgAAA8EAAB0DwAA2RoAAD4GAADoHQAATQkAALIUAAAXAAAAfAsAAOEWAABGAgAAqw0AABAZAAB1BAAA
| 2g8AAD8bAACkBgAACRIAAG4dAADTCAAAOBQAAJ0fAAACCwAAZxYAAMwBAAAxDQAAlhgAAPsDAABgDwAAxRoAACoGAACPEQAA
| 9BwAAFkIAAC+EwAAIx8AAIgKAADtFQAAUgEAALcMAAAcGAAAgQMAAOYOAABLGgAAsAUAABURAAB6HAAA3wcAAEQTAACpHgAA
| DgoAAHMVAADYAAAAPQwAAKIXAAAHAwAAbA4AANEZAAA2BQAAmxAAAAAcAABlBwAAyhIAAC8eAACUCQAA+RQAAF4AAADDCwAA
| KBcAAI0CAADyDQAAVxkAALwEAAAhEAAAhhsAAOsGAABQEgAAtR0AABoJAAB/FAAA5B8AAEkLAACuFgAAEwIAAHgNAADdGAAA
| QgQAAKcPAAAMGwAAcQYAANYRAAA7HQAAoAgAAAUUAABqHwAAzwoAADQWAACZAQAA/gwAAGMYAADIAwAALQ8AAJIaAAD3BQAA
| XBEAAMEcAAAmCAAAixMAAPAeAABVCgAAuhUAAB8BAACEDAAA6RcAAE4DAACzDgAAGBoAAH0FAADiEAAARxwAAKwHAAAREwAA
| dh4AANsJAABAFQAApQAAAAoMAABvFwAA1AIAADkOAACeGQAAAwUAAGgQAADNGwAAMgcAAJcSAAD8HQAAYQkAAMYUAAArAAAA
| kAsAAPUWAABaAgAAvw0AACQZAACJBAAA7g8AAFMbAAC4BgAAHRIAAIIdAADnCAAATBQAALEfAAAWCwAAexYAAOABAABFDQAA
| qhgAAA8EAAB0DwAA2RoAAD4GAACjEQAACB0AAG0IAADSEwAANx8AAJwKAAABFgAAZgEAAMsMAAAwGAAAlQMAAPoOAABfGgAA
| xAUAACkRAACOHAAA8wcAAFgTAAC9HgAAIgoAAIcVAADsAAAAUQwAALYXAAAbAwAAgA4AAOUZAABKBQAArxAAABQcAAB5BwAA
| 3hIAAEMeAACoCQAADRUAAHIAAADXCwAAPBcAAKECAAAGDgAAaxkAANAEAAA1EAAAmhsAAP8GAABkEgAAyR0AAC4JAACTFAAA
| +B8AAF0LAADCFgAAJwIAAIwNAADxGAAAVgQAALsPAAAgGwAAhQYAAOoRAABPHQAAtAgAABkUAAB+HwAA4woAAEgWAACtAQAA
| Eg0AAHcYAADcAwAAQQ8AAKYaAAALBgAAcBEAANUcAAA6CAAAnxMAAAQfAABpCgAAzhUAADMBAACYDAAA/RcAAGIDAADHDgAA
| LBoAAJEFAAD2EAAAWxwAAMAHAAAlEwAAih4AAO8JAABUFQAAuQAAAB4MAACDFwAALQ8AAJIaAAD3BQAAXBEAAMEcAAAmCAAA
| ixMAAPAeAABVCgAAuhUAAB8BAACEDAAA6RcAAE4DAACzDgAAGBoAAH0FAADiEAAARxwAAKwHAAAREwAAdh4AANsJAABAFQAA
| pQAAAAoMAABvFwAA1AIAADkOAACeGQAAAwUAAGgQAADNGwAAMgcAAJcSAAD8HQAAYQkAAMYUAAArAAAAkAsAAPUWAABaAgAA
| vw0AACQZAACJBAAA7g8AAFMbAAC4BgAAHRIAAIIdAADnCAAATBQAALEfAAAWCwAAexYAAOABAABFDQAAqhgAAA8EAAB0DwAA
| 2RoAAD4GAACjEQAACB0AAG0IAADSEwAANx8AAJwKAAABFgAAZgEAAMsMAAAwGAAAlQMAAPoOAABfGgAAxAUAACkRAACOHAAA
| 8wcAAFgTAAC9HgAAIgoAAIcVAADsAAAAUQwAALYXAAAbAwAAgA4AAOUZAABKBQAArxAAABQcAAB5BwAA3hIAAEMeAACoCQAA
| DRUAAHIAAADXCwAAPBcAAKECAAAGDgAAaxkAANAEAAA1EAAAmhsAAP8GAABkEgAAyR0AAC4JAACTFAAA+B8AAF0LAADCFgAA
| JwIAAIwNAADxGAAAVgQAALsPAAAgGwAAhQYAAOoRAABPHQAAtAgAABkUAAB+HwAA4woAAEgWAACtAQAAEg0AAHcYAADcAwAA
| QQ8AAKYaAAALBgAAcBEAANUcAAA6CAAAnxMAAAQfAABpCgAAzhUAADMBAACYDAAA/RcAAGIDAADHDgAALBoAAJEFAAD2EAAA
| WxwAAMAHAAAlEwAAih4AAO8JAABUFQAAuQAAAB4MAACDFwAA6AIAAE0OAACyGQAAFwUAAHwQAADhGwAARgcAAKsSAAAQHgAA
| dQkAANoUAAA/AAAApAsAAAkXAABuAgAA0w0AADgZAACdBAAAAhAAAGcbAADMBgAAMRIAAJYdAAD7CAAAYBQAAMUfAAAqCwAA
| jxYAAPQBAABZDQAAvhgAACMEAACIDwAA7RoAAFIGAAC3EQAAHB0AAIEIAADmEwAASx8AALAKAAAVFgAAegEAAN8MAABEGAAA
| qQMAAA4PAABzGgAA2AUAAD0RAACiHAAABwgAAGwTAADRHgAANgoAAJsVAAAAAQAAZQwAAMoXAAAvAwAAlA4AAPkZAABeBQAA
| wxAAACgcAACNBwAA8hIAAFceAAC8CQAAIRUAAIYAAADrCwAAUBcAALUCAAAaDgAAfxkAAOQEAABJEAAArhsAABMHAAB4EgAA
| 3R0AAEIJAACnFAAADAAAAHELAADWFgAAOwIAAKANAAAFGQAAagQAAM8PAAA0GwAAmQYAAP4RAABjHQAAyAgAAHIAAADXCwAA
| PBcAAKECAAAGDgAAaxkAANAEAAA1EAAAmhsAAP8GAABkEgAAyR0AAC4JAACTFAAA+B8AAF0LAADCFgAAJwIAAIwNAADxGAAA
| VgQAALsPAAAgGwAAhQYAAOoRAABPHQAAtAgAABkUAAB+HwAA4woAAEgWAACtAQAAEg0AAHcYAADcAwAAQQ8AAKYaAAALBgAA
| cBEAANUcAAA6CAAAnxMAAAQfAABpCgAAzhUAADMBAACYDAAA/RcAAGIDAADHDgAALBoAAJEFAAD2EAAAWxwAAMAHAAAlEwAA
| ih4AAO8JAABUFQAAuQAAAB4MAACDFwAA6AIAAE0OAACyGQAAFwUAAHwQAADhGwAARgcAAKsSAAAQHgAAdQkAANoUAAA/AAAA
| pAsAAAkXAABuAgAA0w0AADgZAACdBAAAAhAAAGcbAADMBgAAMRIAAJYdAAD7CAAAYBQAAMUfAAAqCwAAjxYAAPQBAABZDQAA
| vhgAACMEAACIDwAA7RoAAFIGAAC3EQAAHB0AAIEIAADmEwAASx8AALAKAAAVFgAAegEAAN8MAABEGAAAqQMAAA4PAABzGgAA
| 2AUAAD0RAACiHAAABwgAAGwTAADRHgAANgoAAJsVAAAAAQAAZQwAAMoXAAAvAwAAlA4AAPkZAABeBQAAwxAAACgcAACNBwAA
| 8hIAAFceAAC8CQAAIRUAAIYAAADrCwAAUBcAALUCAAAaDgAAfxkAAOQEAABJEAAArhsAABMHAAB4EgAA3R0AAEIJAACnFAAA
| DAAAAHELAADWFgAAOwIAAKANAAAFGQAAagQAAM8PAAA0GwAAmQYAAP4RAABjHQAAyAgAAC0UAACSHwAA9woAAFwWAADBAQAA
| Jg0AAIsYAADwAwAAVQ8AALoaAAAfBgAAhBEAAOkcAABOCAAAsxMAABgfAAB9CgAA4hUAAEcBAACsDAAAERgAAHYDAADbDgAA
| QBoAAKUFAAAKEQAAbxwAANQHAAA5EwAAnh4AAAMKAABoFQAAzQAAADIMAACXFwAA/AIAAGEOAADGGQAAKwUAAJAQAAD1GwAA
| WgcAAL8SAAAkHgAAiQkAAO4UAABTAAAAuAsAAB0XAACCAgAA5w0AAEwZAACxBAAAFhAAAHsbAADgBgAARRIAAKodAAAPCQAA
| dBQAANkfAAA+CwAAoxYAAAgCAABtDQAA0hgAADcEAACcDwAAARsAAGYGAADLEQAAMB0AAJUIAAD6EwAAXx8AAMQKAAApFgAA
| jgEAAPMMAABYGAAAvQMAACIPAACHGgAA7AUAAFERAAC2HAAAGwgAAIATAADlHgAASgoAAK8VAAAUAQAAeQwAAN4XAABDAwAA
| qA4AAA0aAAC3EQAAHB0AAIEIAADmEwAASx8AALAKAAAVFgAAegEAAN8MAABEGAAAqQMAAA4PAABzGgAA2AUAAD0RAACiHAAA
| BwgAAGwTAADRHgAANgoAAJsVAAAAAQAAZQwAAMoXAAAvAwAAlA4AAPkZAABeBQAAwxAAACgcAACNBwAA8hIAAFceAAC8CQAA
| IRUAAIYAAADrCwAAUBcAALUCAAAaDgAAfxkAAOQEAABJEAAArhsAABMHAAB4EgAA3R0AAEIJAACnFAAADAAAAHELAADWFgAA
| OwIAAKANAAAFGQAAagQAAM8PAAA0GwAAmQYAAP4RAABjHQAAyAgAAC0UAACSHwAA9woAAFwWAADBAQAAJg0AAIsYAADwAwAA
| VQ8AALoaAAAfBgAAhBEAAOkcAABOCAAAsxMAABgfAAB9CgAA4hUAAEcBAACsDAAAERgAAHYDAADbDgAAQBoAAKUFAAAKEQAA
| bxwAANQHAAA5EwAAnh4AAAMKAABoFQAAzQAAADIMAACXFwAA/AIAAGEOAADGGQAAKwUAAJAQAAD1GwAAWgcAAL8SAAAkHgAA
| iQkAAO4UAABTAAAAuAsAAB0XAACCAgAA5w0AAEwZAACxBAAAFhAAAHsbAADgBgAARRIAAKodAAAPCQAAdBQAANkfAAA+CwAA
| oxYAAAgCAABtDQAA0hgAADcEAACcDwAAARsAAGYGAADLEQAAMB0AAJUIAAD6EwAAXx8AAMQKAAApFgAAjgEAAPMMAABYGAAA
| vQMAACIPAACHGgAA7AUAAFERAAC2HAAAGwgAAIATAADlHgAASgoAAK8VAAAUAQAAeQwAAN4XAABDAwAAqA4AAA0aAAByBQAA
| 1xAAADwcAAChBwAABhMAAGseAADQCQAANRUAAJoAAAD/CwAAZBcAAMkCAAAuDgAAkxkAAPgEAABdEAAAwhsAACcHAACMEgAA
| 8R0AAFYJAAC7FAAAIAAAAIULAADqFgAATwIAALQNAAAZGQAAfgQAAOMPAABIGwAArQYAABISAAB3HQAA3AgAAEEUAACmHwAA
| CwsAAHAWAADVAQAAOg0AAJ8YAAAEBAAAaQ8AAM4aAAAzBgAAmBEAAP0cAABiCAAAxxMAACwfAACRCgAA9hUAAFsBAADADAAA
| JRgAAIoDAADvDgAAVBoAALkFAAAeEQAAgxwAAOgHAABNEwAAsh4AABcKAAB8FQAA4QAAAEYMAACrFwAAEAMAAHUOAADaGQAA
| PwUAAKQQAAAJHAAAbgcAANMSAAA4HgAAnQkAAAIVAABnAAAAzAsAADEXAACWAgAA+w0AAGAZAADFBAAAKhAAAI8bAAD0BgAA
| WRIAAL4dAAAjCQAAiBQAAO0fAABSCwAA/AIAAGEOAADGGQAAKwUAAJAQAAD1GwAAWgcAAL8SAAAkHgAAiQkAAO4UAABTAAAA
| uAsAAB0XAACCAgAA5w0AAEwZAACxBAAAFhAAAHsbAADgBgAARRIAAKodAAAPCQAAdBQAANkfAAA+CwAAoxYAAAgCAABtDQAA
| 0hgAADcEAACcDwAAARsAAGYGAADLEQAAMB0AAJUIAAD6EwAAXx8AAMQKAAApFgAAjgEAAPMMAABYGAAAvQMAACIPAACHGgAA
| 7AUAAFERAAC2HAAAGwgAAIATAADlHgAASgoAAK8VAAAUAQAAeQwAAN4XAABDAwAAqA4AAA0aAAByBQAA1xAAADwcAAChBwAA
| BhMAAGseAADQCQAANRUAAJoAAAD/CwAAZBcAAMkCAAAuDgAAkxkAAPgEAABdEAAAwhsAACcHAACMEgAA8R0AAFYJAAC7FAAA
| IAAAAIULAADqFgAATwIAALQNAAAZGQAAfgQAAOMPAABIGwAArQYAABISAAB3HQAA3AgAAEEUAACmHwAACwsAAHAWAADVAQAA
| Og0AAJ8YAAAEBAAAaQ8AAM4aAAAzBgAAmBEAAP0cAABiCAAAxxMAACwfAACRCgAA9hUAAFsBAADADAAAJRgAAIoDAADvDgAA
| VBoAALkFAAAeEQAAgxwAAOgHAABNEwAAsh4AABcKAAB8FQAA4QAAAEYMAACrFwAAEAMAAHUOAADaGQAAPwUAAKQQAAAJHAAA
| bgcAANMSAAA4HgAAnQkAAAIVAABnAAAAzAsAADEXAACWAgAA+w0AAGAZAADFBAAAKhAAAI8bAAD0BgAAWRIAAL4dAAAjCQAA
| iBQAAO0fAABSCwAAtxYAABwCAACBDQAA5hgAAEsEAACwDwAAFRsAAHoGAADfEQAARB0AAKkIAAAOFAAAcx8AANgKAAA9FgAA
| ogEAAAcNAABsGAAA0QMAADYPAACbGgAAAAYAAGURAADKHAAALwgAAJQTAAD5HgAAXgoAAMMVAAAoAQAAjQwAAPIXAABXAwAA
| vA4AACEaAACGBQAA6xAAAFAcAAC1BwAAGhMAAH8eAADkCQAASRUAAK4AAAATDAAAeBcAAN0CAABCDgAApxkAAAwFAABxEAAA
| 1hsAADsHAACgEgAABR4AAGoJAADPFAAANAAAAJkLAAD+FgAAYwIAAMgNAAAtGQAAkgQAAPcPAABcGwAAwQYAACYSAACLHQAA
| 8AgAAFUUAAC6HwAAHwsAAIQWAADpAQAATg0AALMYAAAYBAAAfQ8AAOIaAABHBgAArBEAABEdAAB2CAAA2xMAAEAfAAClCgAA
| ChYAAG8BAADUDAAAORgAAJ4DAAADDwAAaBoAAM0FAAAyEQAAlxwAAEEUAACmHwAACwsAAHAWAADVAQAAOg0AAJ8YAAAEBAAA
| aQ8AAM4aAAAzBgAAmBEAAP0cAABiCAAAxxMAACwfAACRCgAA9hUAAFsBAADADAAAJRgAAIoDAADvDgAAVBoAALkFAAAeEQAA
| gxwAAOgHAABNEwAAsh4AABcKAAB8FQAA4QAAAEYMAACrFwAAEAMAAHUOAADaGQAAPwUAAKQQAAAJHAAAbgcAANMSAAA4HgAA
| nQkAAAIVAABnAAAAzAsAADEXAACWAgAA+w0AAGAZAADFBAAAKhAAAI8bAAD0BgAAWRIAAL4dAAAjCQAAiBQAAO0fAABSCwAA
| txYAABwCAACBDQAA5hgAAEsEAACwDwAAFRsAAHoGAADfEQAARB0AAKkIAAAOFAAAcx8AANgKAAA9FgAAogEAAAcNAABsGAAA
| 0QMAADYPAACbGgAAAAYAAGURAADKHAAALwgAAJQTAAD5HgAAXgoAAMMVAAAoAQAAjQwAAPIXAABXAwAAvA4AACEaAACGBQAA
| 6xAAAFAcAAC1BwAAGhMAAH8eAADkCQAASRUAAK4AAAATDAAAeBcAAN0CAABCDgAApxkAAAwFAABxEAAA1hsAADsHAACgEgAA
| BR4AAGoJAADPFAAANAAAAJkLAAD+FgAAYwIAAMgNAAAtGQAAkgQAAPcPAABcGwAAwQYAACYSAACLHQAA8AgAAFUUAAC6HwAA
| HwsAAIQWAADpAQAATg0AALMYAAAYBAAAfQ8AAOIaAABHBgAArBEAABEdAAB2CAAA2xMAAEAfAAClCgAAChYAAG8BAADUDAAA
| ORgAAJ4DAAADDwAAaBoAAM0FAAAyEQAAlxwAAPwHAABhEwAAxh4AACsKAACQFQAA9QAAAFoMAAC/FwAAJAMAAIkOAADuGQAA
| UwUAALgQAAAdHAAAggcAAOcSAABMHgAAsQkAABYVAAB7AAAA4AsAAEUXAACqAgAADw4AAHQZAADZBAAAPhAAAKMbAAAIBwAA
| bRIAANIdAAA3CQAAnBQAAAEAAABmCwAAyxYAADACAACVDQAA+hgAAF8EAADEDwAAKRsAAI4GAADzEQAAWB0AAL0IAAAiFAAA
| hx8AAOwKAABRFgAAtgEAABsNAACAGAAA5QMAAEoPAACvGgAAFAYAAHkRAADeHAAAQwgAAKgTAAANHwAAcgoAANcVAAA8AQAA
| oQwAAAYYAABrAwAA0A4AADUaAACaBQAA/xAAAGQcAADJBwAALhMAAJMeAAD4CQAAXRUAAMIAAAAnDAAAjBcAAPECAABWDgAA
| uxkAACAFAACFEAAA6hsAAE8HAAC0EgAAGR4AAH4JAADjFAAASAAAAK0LAAASFwAAdwIAANwNAACGBQAA6xAAAFAcAAC1BwAA
| GhMAAH8eAADkCQAASRUAAK4AAAATDAAAeBcAAN0CAABCDgAApxkAAAwFAABxEAAA1hsAADsHAACgEgAABR4AAGoJAADPFAAA
| NAAAAJkLAAD+FgAAYwIAAMgNAAAtGQAAkgQAAPcPAABcGwAAwQYAACYSAACLHQAA8AgAAFUUAAC6HwAAHwsAAIQWAADpAQAA
| Tg0AALMYAAAYBAAAfQ8AAOIaAABHBgAArBEAABEdAAB2CAAA2xMAAEAfAAClCgAAChYAAG8BAADUDAAAORgAAJ4DAAADDwAA
| aBoAAM0FAAAyEQAAlxwAAPwHAABhEwAAxh4AACsKAACQFQAA9QAAAFoMAAC/FwAAJAMAAIkOAADuGQAAUwUAALgQAAAdHAAA
| ggcAAOcSAABMHgAAsQkAABYVAAB7AAAA4AsAAEUXAACqAgAADw4AAHQZAADZBAAAPhAAAKMbAAAIBwAAbRIAANIdAAA3CQAA
| nBQAAAEAAABmCwAAyxYAADACAACVDQAA+hgAAF8EAADEDwAAKRsAAI4GAADzEQAAWB0AAL0IAAAiFAAAhx8AAOwKAABRFgAA
| tgEAABsNAACAGAAA5QMAAEoPAACvGgAAFAYAAHkRAADeHAAAQwgAAKgTAAANHwAAcgoAANcVAAA8AQAAoQwAAAYYAABrAwAA
| 0A4AADUaAACaBQAA/xAAAGQcAADJBwAALhMAAJMeAAD4CQAAXRUAAMIAAAAnDAAAjBcAAPECAABWDgAAuxkAACAFAACFEAAA
| 6hsAAE8HAAC0EgAAGR4AAH4JAADjFAAASAAAAK0LAAASFwAAdwIAANwNAABBGQAApgQAAAsQAABwGwAA1QYAADoSAACfHQAA
| BAkAAGkUAADOHwAAMwsAAJgWAAD9AQAAYg0AAMcYAAAsBAAAkQ8AAPYaAABbBgAAwBEAACUdAACKCAAA7xMAAFQfAAC5CgAA
| HhYAAIMBAADoDAAATRgAALIDAAAXDwAAfBoAAOEFAABGEQAAqxwAABAIAAB1EwAA2h4AAD8KAACkFQAACQEAAG4MAADTFwAA
| OAMAAJ0OAAACGgAAZwUAAMwQAAAxHAAAlgcAAPsSAABgHgAAxQkAACoVAACPAAAA9AsAAFkXAAC+AgAAIw4AAIgZAADtBAAA
| UhAAALcbAAAcBwAAgRIAAOYdAABLCQAAsBQAABUAAAB6CwAA3xYAAEQCAACpDQAADhkAAHMEAADYDwAAPRsAAKIGAAAHEgAA
| bB0AANEIAAA2FAAAmx8AAAALAABlFgAAygEAAC8NAACUGAAA+QMAAF4PAADDGgAAKAYAAI0RAADyHAAAVwgAALwTAAAhHwAA
| yxYAADACAACVDQAA+hgAAF8EAADEDwAAKRsAAI4GAADzEQAAWB0AAL0IAAAiFAAAhx8AAOwKAABRFgAAtgEAABsNAACAGAAA
| 5QMAAEoPAACvGgAAFAYAAHkRAADeHAAAQwgAAKgTAAANHwAAcgoAANcVAAA8AQAAoQwAAAYYAABrAwAA0A4AADUaAACaBQAA
| /xAAAGQcAADJBwAALhMAAJMeAAD4CQAAXRUAAMIAAAAnDAAAjBcAAPECAABWDgAAuxkAACAFAACFEAAA6hsAAE8HAAC0EgAA
| GR4AAH4JAADjFAAASAAAAK0LAAASFwAAdwIAANwNAABBGQAApgQAAAsQAABwGwAA1QYAADoSAACfHQAABAkAAGkUAADOHwAA
| MwsAAJgWAAD9AQAAYg0AAMcYAAAsBAAAkQ8AAPYaAABbBgAAwBEAACUdAACKCAAA7xMAAFQfAAC5CgAAHhYAAIMBAADoDAAA
| TRgAALIDAAAXDwAAfBoAAOEFAABGEQAAqxwAABAIAAB1EwAA2h4AAD8KAACkFQAACQEAAG4MAADTFwAAOAMAAJ0OAAACGgAA
| ZwUAAMwQAAAxHAAAlgcAAPsSAABgHgAAxQkAACoVAACPAAAA9AsAAFkXAAC+AgAAIw4AAIgZAADtBAAAUhAAALcbAAAcBwAA
| gRIAAOYdAABLCQAAsBQAABUAAAB6CwAA3xYAAEQCAACpDQAADhkAAHMEAADYDwAAPRsAAKIGAAAHEgAAbB0AANEIAAA2FAAA
| mx8AAAALAABlFgAAygEAAC8NAACUGAAA+QMAAF4PAADDGgAAKAYAAI0RAADyHAAAVwgAALwTAAAhHwAAhgoAAOsVAABQAQAA
| tQwAABoYAAB/AwAA5A4AAEkaAACuBQAAExEAAHgcAADdBwAAQhMAAKceAAAMCgAAcRUAANYAAAA7DAAAoBcAAAUDAABqDgAA
| zxkAADQFAACZEAAA/hsAAGMHAADIEgAALR4AAJIJAAD3FAAAXAAAAMELAAAmFwAAiwIAAPANAABVGQAAugQAAB8QAACEGwAA
| 6QYAAE4SAACzHQAAGAkAAH0UAADiHwAARwsAAKwWAAARAgAAdg0AANsYAABABAAApQ8AAAobAABvBgAA1BEAADkdAACeCAAA
| AxQAAGgfAADNCgAAMhYAAJcBAAD8DAAAYRgAAMYDAAArDwAAkBoAAPUFAABaEQAAvxwAACQIAACJEwAA7h4AAFMKAAC4FQAA
| HQEAAIIMAADnFwAATAMAALEOAAAWGgAAewUAAOAQAABFHAAAqgcAAA8TAAB0HgAA2QkAAD4VAACjAAAACAwAAG0XAADSAgAA
| Nw4AAJwZAAABBQAAZhAAABAIAAB1EwAA2h4AAD8KAACkFQAACQEAAG4MAADTFwAAOAMAAJ0OAAACGgAAZwUAAMwQAAAxHAAA
| lgcAAPsSAABgHgAAxQkAACoVAACPAAAA9AsAAFkXAAC+AgAAIw4AAIgZAADtBAAAUhAAALcbAAAcBwAAgRIAAOYdAABLCQAA
| sBQAABUAAAB6CwAA3xYAAEQCAACpDQAADhkAAHMEAADYDwAAPRsAAKIGAAAHEgAAbB0AANEIAAA2FAAAmx8AAAALAABlFgAA
| ygEAAC8NAACUGAAA+QMAAF4PAADDGgAAKAYAAI0RAADyHAAAVwgAALwTAAAhHwAAhgoAAOsVAABQAQAAtQwAABoYAAB/AwAA
| 5A4AAEkaAACuBQAAExEAAHgcAADdBwAAQhMAAKceAAAMCgAAcRUAANYAAAA7DAAAoBcAAAUDAABqDgAAzxkAADQFAACZEAAA
| /hsAAGMHAADIEgAALR4AAJIJAAD3FAAAXAAAAMELAAAmFwAAiwIAAPANAABVGQAAugQAAB8QAACEGwAA6QYAAE4SAACzHQAA
| GAkAAH0UAADiHwAARwsAAKwWAAARAgAAdg0AANsYAABABAAApQ8AAAobAABvBgAA1BEAADkdAACeCAAAAxQAAGgfAADNCgAA
| MhYAAJcBAAD8DAAAYRgAAMYDAAArDwAAkBoAAPUFAABaEQAAvxwAACQIAACJEwAA7h4AAFMKAAC4FQAAHQEAAIIMAADnFwAA
| TAMAALEOAAAWGgAAewUAAOAQAABFHAAAqgcAAA8TAAB0HgAA2QkAAD4VAACjAAAACAwAAG0XAADSAgAANw4AAJwZAAABBQAA
| ZhAAAMsbAAAwBwAAlRIAAPodAABfCQAAxBQAACkAAACOCwAA8xYAAFgCAAC9DQAAIhkAAIcEAADsDwAAURsAALYGAAAbEgAA
| gB0AAOUIAABKFAAArx8AABQLAAB5FgAA3gEAAEMNAACoGAAADQQAAHIPAADXGgAAPAYAAKERAAAGHQAAawgAANATAAA1HwAA
| mgoAAP8VAABkAQAAyQwAAC4YAACTAwAA+A4AAF0aAADCBQAAJxEAAIwcAADxBwAAVhMAALseAAAgCgAAhRUAAOoAAABPDAAA
| tBcAABkDAAB+DgAA4xkAAEgFAACtEAAAEhwAAHcHAADcEgAAQR4AAKYJAAALFQAAcAAAANULAAA6FwAAnwIAAAQOAABpGQAA
| zgQAADMQAACYGwAA/QYAAGISAADHHQAALAkAAJEUAAD2HwAAWwsAAMAWAAAlAgAAig0AAO8YAABUBAAAuQ8AAB4bAACDBgAA
| 6BEAAE0dAACyCAAAFxQAAHwfAADhCgAARhYAAKsBAABVGQAAugQAAB8QAACEGwAA6QYAAE4SAACzHQAAGAkAAH0UAADiHwAA
| RwsAAKwWAAARAgAAdg0AANsYAABABAAApQ8AAAobAABvBgAA1BEAADkdAACeCAAAAxQAAGgfAADNCgAAMhYAAJcBAAD8DAAA
| YRgAAMYDAAArDwAAkBoAAPUFAABaEQAAvxwAACQIAACJEwAA7h4AAFMKAAC4FQAAHQEAAIIMAADnFwAATAMAALEOAAAWGgAA
| ewUAAOAQAABFHAAAqgcAAA8TAAB0HgAA2QkAAD4VAACjAAAACAwAAG0XAADSAgAANw4AAJwZAAABBQAAZhAAAMsbAAAwBwAA
| lRIAAPodAABfCQAAxBQAACkAAACOCwAA8xYAAFgCAAC9DQAAIhkAAIcEAADsDwAAURsAALYGAAAbEgAAgB0AAOUIAABKFAAA
| rx8AABQLAAB5FgAA3gEAAEMNAACoGAAADQQAAHIPAADXGgAAPAYAAKERAAAGHQAAawgAANATAAA1HwAAmgoAAP8VAABkAQAA
| yQwAAC4YAACTAwAA+A4AAF0aAADCBQAAJxEAAIwcAADxBwAAVhMAALseAAAgCgAAhRUAAOoAAABPDAAAtBcAABkDAAB+DgAA
| 4xkAAEgFAACtEAAAEhwAAHcHAADcEgAAQR4AAKYJAAALFQAAcAAAANULAAA6FwAAnwIAAAQOAABpGQAAzgQAADMQAACYGwAA
| /QYAAGISAADHHQAALAkAAJEUAAD2HwAAWwsAAMAWAAAlAgAAig0AAO8YAABUBAAAuQ8AAB4bAACDBgAA6BEAAE0dAACyCAAA
| FxQAAHwfAADhCgAARhYAAKsBAAAQDQAAdRgAANoDAAA/DwAApBoAAAkGAABuEQAA0xwAADgIAACdEwAAAh8AAGcKAADMFQAA
| MQEAAJYMAAD7FwAAYAMAAMUOAAAqGgAAjwUAAPQQAABZHAAAvgcAACMTAACIHgAA7QkAAFIVAAC3AAAAHAwAAIEXAADmAgAA
| Sw4AALAZAAAVBQAAehAAAN8bAABEBwAAqRIAAA4eAABzCQAA2BQAAD0AAACiCwAABxcAAGwCAADRDQAANhkAAJsEAAAAEAAA
| ZRsAAMoGAAAvEgAAlB0AAPkIAABeFAAAwx8AACgLAACNFgAA8gEAAFcNAAC8GAAAIQQAAIYPAADrGgAAUAYAALURAAAaHQAA
| fwgAAOQTAABJHwAArgoAABMWAAB4AQAA3QwAAEIYAACnAwAADA8AAHEaAADWBQAAOxEAAKAcAAAFCAAAahMAAM8eAAA0CgAA
| mRUAAP4AAABjDAAAyBcAAC0DAACSDgAA9xkAAFwFAADBEAAAJhwAAIsHAADwEgAAmgoAAP8VAABkAQAAyQwAAC4YAACTAwAA
| +A4AAF0aAADCBQAAJxEAAIwcAADxBwAAVhMAALseAAAgCgAAhRUAAOoAAABPDAAAtBcAABkDAAB+DgAA4xkAAEgFAACtEAAA
| EhwAAHcHAADcEgAAQR4AAKYJAAALFQAAcAAAANULAAA6FwAAnwIAAAQOAABpGQAAzgQAADMQAACYGwAA/QYAAGISAADHHQAA
| LAkAAJEUAAD2HwAAWwsAAMAWAAAlAgAAig0AAO8YAABUBAAAuQ8AAB4bAACDBgAA6BEAAE0dAACyCAAAFxQAAHwfAADhCgAA
| RhYAAKsBAAAQDQAAdRgAANoDAAA/DwAApBoAAAkGAABuEQAA0xwAADgIAACdEwAAAh8AAGcKAADMFQAAMQEAAJYMAAD7FwAA
| YAMAAMUOAAAqGgAAjwUAAPQQAABZHAAAvgcAACMTAACIHgAA7QkAAFIVAAC3AAAAHAwAAIEXAADmAgAASw4AALAZAAAVBQAA
| ehAAAN8bAABEBwAAqRIAAA4eAABzCQAA2BQAAD0AAACiCwAABxcAAGwCAADRDQAANhkAAJsEAAAAEAAAZRsAAMoGAAAvEgAA
| lB0AAPkIAABeFAAAwx8AACgLAACNFgAA8gEAAFcNAAC8GAAAIQQAAIYPAADrGgAAUAYAALURAAAaHQAAfwgAAOQTAABJHwAA
| rgoAABMWAAB4AQAA3QwAAEIYAACnAwAADA8AAHEaAADWBQAAOxEAAKAcAAAFCAAAahMAAM8eAAA0CgAAmRUAAP4AAABjDAAA
| yBcAAC0DAACSDgAA9xkAAFwFAADBEAAAJhwAAIsHAADwEgAAVR4AALoJAAAfFQAAhAAAAOkLAABOFwAAswIAABgOAAB9GQAA
| 4gQAAEcQAACsGwAAEQcAAHYSAADbHQAAQAkAAKUUAAAKAAAAbwsAANQWAAA5AgAAng0AAAMZAABoBAAAzQ8AADIbAACXBgAA
| /BEAAGEdAADGCAAAKxQAAJAfAAD1CgAAWhYAAL8BAAAkDQAAiRgAAO4DAABTDwAAuBoAAB0GAACCEQAA5xwAAEwIAACxEwAA
| Fh8AAHsKAADgFQAARQEAAKoMAAAPGAAAdAMAANkOAAA+GgAAowUAAAgRAABtHAAA0gcAADcTAACcHgAAAQoAAGYVAADLAAAA
| MAwAAJUXAAD6AgAAXw4AAMQZAAApBQAAjhAAAPMbAABYBwAAvRIAACIeAACHCQAA7BQAAFEAAAC2CwAAGxcAAIACAADlDQAA
| ShkAAK8EAAAUEAAAeRsAAN4GAABDEgAAqB0AAA0JAAByFAAA1x8AADwLAAChFgAABgIAAGsNAADQGAAANQQAAN8bAABEBwAA
| qRIAAA4eAABzCQAA2BQAAD0AAACiCwAABxcAAGwCAADRDQAANhkAAJsEAAAAEAAAZRsAAMoGAAAvEgAAlB0AAPkIAABeFAAA
| wx8AACgLAACNFgAA8gEAAFcNAAC8GAAAIQQAAIYPAADrGgAAUAYAALURAAAaHQAAfwgAAOQTAABJHwAArgoAABMWAAB4AQAA
| 3QwAAEIYAACnAwAADA8AAHEaAADWBQAAOxEAAKAcAAAFCAAAahMAAM8eAAA0CgAAmRUAAP4AAABjDAAAyBcAAC0DAACSDgAA
| 9xkAAFwFAADBEAAAJhwAAIsHAADwEgAAVR4AALoJAAAfFQAAhAAAAOkLAABOFwAAswIAABgOAAB9GQAA4gQAAEcQAACsGwAA
| EQcAAHYSAADbHQAAQAkAAKUUAAAKAAAAbwsAANQWAAA5AgAAng0AAAMZAABoBAAAzQ8AADIbAACXBgAA/BEAAGEdAADGCAAA
| KxQAAJAfAAD1CgAAWhYAAL8BAAAkDQAAiRgAAO4DAABTDwAAuBoAAB0GAACCEQAA5xwAAEwIAACxEwAAFh8AAHsKAADgFQAA
| RQEAAKoMAAAPGAAAdAMAANkOAAA+GgAAowUAAAgRAABtHAAA0gcAADcTAACcHgAAAQoAAGYVAADLAAAAMAwAAJUXAAD6AgAA
| Xw4AAMQZAAApBQAAjhAAAPMbAABYBwAAvRIAACIeAACHCQAA7BQAAFEAAAC2CwAAGxcAAIACAADlDQAAShkAAK8EAAAUEAAA
| eRsAAN4GAABDEgAAqB0AAA0JAAByFAAA1x8AADwLAAChFgAABgIAAGsNAADQGAAANQQAAJoPAAD/GgAAZAYAAMkRAAAuHQAA
| kwgAAPgTAABdHwAAwgoAACcWAACMAQAA8QwAAFYYAAC7AwAAIA8AAIUaAADqBQAATxEAALQcAAAZCAAAfhMAAOMeAABICgAA
| rRUAABIBAAB3DAAA3BcAAEEDAACmDgAACxoAAHAFAADVEAAAOhwAAJ8HAAAEEwAAaR4AAM4JAAAzFQAAmAAAAP0LAABiFwAA
| xwIAACwOAACRGQAA9gQAAFsQAADAGwAAJQcAAIoSAADvHQAAVAkAALkUAAAeAAAAgwsAAOgWAABNAgAAsg0AABcZAAB8BAAA
| 4Q8AAEYbAACrBgAAEBIAAHUdAADaCAAAPxQAAKQfAAAJCwAAbhYAANMBAAA4DQAAnRgAAAIEAABnDwAAzBoAADEGAACWEQAA
| +xwAAGAIAADFEwAAKh8AAI8KAAD0FQAAWQEAAL4MAAAjGAAAiAMAAO0OAABSGgAAtwUAABwRAACBHAAA5gcAAEsTAACwHgAA
| FQoAAHoVAAAkDQAAiRgAAO4DAABTDwAAuBoAAB0GAACCEQAA5xwAAEwIAACxEwAAFh8AAHsKAADgFQAARQEAAKoMAAAPGAAA
| dAMAANkOAAA+GgAAowUAAAgRAABtHAAA0gcAADcTAACcHgAAAQoAAGYVAADLAAAAMAwAAJUXAAD6AgAAXw4AAMQZAAApBQAA
| jhAAAPMbAABYBwAAvRIAACIeAACHCQAA7BQAAFEAAAC2CwAAGxcAAIACAADlDQAAShkAAK8EAAAUEAAAeRsAAN4GAABDEgAA
| qB0AAA0JAAByFAAA1x8AADwLAAChFgAABgIAAGsNAADQGAAANQQAAJoPAAD/GgAAZAYAAMkRAAAuHQAAkwgAAPgTAABdHwAA
| wgoAACcWAACMAQAA8QwAAFYYAAC7AwAAIA8AAIUaAADqBQAATxEAALQcAAAZCAAAfhMAAOMeAABICgAArRUAABIBAAB3DAAA
| 3BcAAEEDAACmDgAACxoAAHAFAADVEAAAOhwAAJ8HAAAEEwAAaR4AAM4JAAAzFQAAmAAAAP0LAABiFwAAxwIAACwOAACRGQAA
| 9gQAAFsQAADAGwAAJQcAAIoSAADvHQAAVAkAALkUAAAeAAAAgwsAAOgWAABNAgAAsg0AABcZAAB8BAAA4Q8AAEYbAACrBgAA
| EBIAAHUdAADaCAAAPxQAAKQfAAAJCwAAbhYAANMBAAA4DQAAnRgAAAIEAABnDwAAzBoAADEGAACWEQAA+xwAAGAIAADFEwAA
| Kh8AAI8KAAD0FQAAWQEAAL4MAAAjGAAAiAMAAO0OAABSGgAAtwUAABwRAACBHAAA5gcAAEsTAACwHgAAFQoAAHoVAADfAAAA
| RAwAAKkXAAAOAwAAcw4AANgZAAA9BQAAohAAAAccAABsBwAA0RIAADYeAACbCQAAABUAAGUAAADKCwAALxcAAJQCAAD5DQAA
| XhkAAMMEAAAoEAAAjRsAAPIGAABXEgAAvB0AACEJAACGFAAA6x8AAFALAAC1FgAAGgIAAH8NAADkGAAASQQAAK4PAAATGwAA
| eAYAAN0RAABCHQAApwgAAAwUAABxHwAA1goAADsWAACgAQAABQ0AAGoYAADPAwAANA8AAJkaAAD+BQAAYxEAAMgcAAAtCAAA
| khMAAPceAABcCgAAwRUAACYBAACLDAAA8BcAAFUDAAC6DgAAHxoAAIQFAADpEAAAThwAALMHAAAYEwAAfR4AAOIJAABHFQAA
| rAAAABEMAAB2FwAA2wIAAEAOAAClGQAACgUAAG8QAADUGwAAOQcAAJ4SAAADHgAAaAkAAM0UAAAyAAAAlwsAAPwWAABhAgAA
| xg0AACsZAACQBAAA9Q8AAFobAAC/BgAAaR4AAM4JAAAzFQAAmAAAAP0LAABiFwAAxwIAACwOAACRGQAA9gQAAFsQAADAGwAA
| JQcAAIoSAADvHQAAVAkAALkUAAAeAAAAgwsAAOgWAABNAgAAsg0AABcZAAB8BAAA4Q8AAEYbAACrBgAAEBIAAHUdAADaCAAA
| PxQAAKQfAAAJCwAAbhYAANMBAAA4DQAAnRgAAAIEAABnDwAAzBoAADEGAACWEQAA+xwAAGAIAADFEwAAKh8AAI8KAAD0FQAA
| WQEAAL4MAAAjGAAAiAMAAO0OAABSGgAAtwUAABwRAACBHAAA5gcAAEsTAACwHgAAFQoAAHoVAADfAAAARAwAAKkXAAAOAwAA
| cw4AANgZAAA9BQAAohAAAAccAABsBwAA0RIAADYeAACbCQAAABUAAGUAAADKCwAALxcAAJQCAAD5DQAAXhkAAMMEAAAoEAAA
| jRsAAPIGAABXEgAAvB0AACEJAACGFAAA6x8AAFALAAC1FgAAGgIAAH8NAADkGAAASQQAAK4PAAATGwAAeAYAAN0RAABCHQAA
| pwgAAAwUAABxHwAA1goAADsWAACgAQAABQ0AAGoYAADPAwAANA8AAJkaAAD+BQAAYxEAAMgcAAAtCAAAkhMAAPceAABcCgAA
| wRUAACYBAACLDAAA8BcAAFUDAAC6DgAAHxoAAIQFAADpEAAAThwAALMHAAAYEwAAfR4AAOIJAABHFQAArAAAABEMAAB2FwAA
| 2wIAAEAOAAClGQAACgUAAG8QAADUGwAAOQcAAJ4SAAADHgAAaAkAAM0UAAAyAAAAlwsAAPwWAABhAgAAxg0AACsZAACQBAAA
| 9Q8AAFobAAC/BgAAJBIAAIkdAADuCAAAUxQAALgfAAAdCwAAghYAAOcBAABMDQAAsRgAABYEAAB7DwAA4BoAAEUGAACqEQAA
| Dx0AAHQIAADZEwAAPh8AAKMKAAAIFgAAbQEAANIMAAA3GAAAnAMAAAEPAABmGgAAywUAADARAACVHAAA+gcAAF8TAADEHgAA
| KQoAAI4VAADzAAAAWAwAAL0XAAAiAwAAhw4AAOwZAABRBQAAthAAABscAACABwAA5RIAAEoeAACvCQAAFBUAAHkAAADeCwAA
| QxcAAKgCAAANDgAAchkAANcEAAA8EAAAoRsAAAYHAABrEgAA0B0AADUJAACaFAAA/x8AAGQLAADJFgAALgIAAJMNAAD4GAAA
| XQQAAMIPAAAnGwAAjAYAAPERAABWHQAAuwgAACAUAACFHwAA6goAAE8WAAC0AQAAGQ0AAH4YAADjAwAASA8AAK0aAAASBgAA
| dxEAANwcAABBCAAAphMAAAsfAABwCgAA1RUAADoBAACfDAAABBgAAK4PAAATGwAAeAYAAN0RAABCHQAApwgAAAwUAABxHwAA
| 1goAADsWAACgAQAABQ0AAGoYAADPAwAANA8AAJkaAAD+BQAAYxEAAMgcAAAtCAAAkhMAAPceAABcCgAAwRUAACYBAACLDAAA
| 8BcAAFUDAAC6DgAAHxoAAIQFAADpEAAAThwAALMHAAAYEwAAfR4AAOIJAABHFQAArAAAABEMAAB2FwAA2wIAAEAOAAClGQAA
| CgUAAG8QAADUGwAAOQcAAJ4SAAADHgAAaAkAAM0UAAAyAAAAlwsAAPwWAABhAgAAxg0AACsZAACQBAAA9Q8AAFobAAC/BgAA
| JBIAAIkdAADuCAAAUxQAALgfAAAdCwAAghYAAOcBAABMDQAAsRgAABYEAAB7DwAA4BoAAEUGAACqEQAADx0AAHQIAADZEwAA
| Ph8AAKMKAAAIFgAAbQEAANIMAAA3GAAAnAMAAAEPAABmGgAAywUAADARAACVHAAA+gcAAF8TAADEHgAAKQoAAI4VAADzAAAA
| WAwAAL0XAAAiAwAAhw4AAOwZAABRBQAAthAAABscAACABwAA5RIAAEoeAACvCQAAFBUAAHkAAADeCwAAQxcAAKgCAAANDgAA
| chkAANcEAAA8EAAAoRsAAAYHAABrEgAA0B0AADUJAACaFAAA/x8AAGQLAADJFgAALgIAAJMNAAD4GAAAXQQAAMIPAAAnGwAA
| jAYAAPERAABWHQAAuwgAACAUAACFHwAA6goAAE8WAAC0AQAAGQ0AAH4YAADjAwAASA8AAK0aAAASBgAAdxEAANwcAABBCAAA
| phMAAAsfAABwCgAA1RUAADoBAACfDAAABBgAAGkDAADODgAAMxoAAJgFAAD9EAAAYhwAAMcHAAAsEwAAkR4AAPYJAABbFQAA
| wAAAACUMAACKFwAA7wIAAFQOAAC5GQAAHgUAAIMQAADoGwAATQcAALISAAAXHgAAfAkAAOEUAABGAAAAqwsAABAXAAB1AgAA
| 2g0AAD8ZAACkBAAACRAAAG4bAADTBgAAOBIAAJ0dAAACCQAAZxQAAMwfAAAxCwAAlhYAAPsBAABgDQAAxRgAACoEAACPDwAA
| 9BoAAFkGAAC+EQAAIx0AAIgIAADtEwAAUh8AALcKAAAcFgAAgQEAAOYMAABLGAAAsAMAABUPAAB6GgAA3wUAAEQRAACpHAAA
| DggAAHMTAADYHgAAPQoAAKIVAAAHAQAAbAwAANEXAAA2AwAAmw4AAAAaAABlBQAAyhAAAC8cAACUBwAA+RIAAF4eAADDCQAA
| KBUAAI0AAADyCwAAVxcAALwCAAAhDgAAhhkAAOsEAABQEAAAtRsAABoHAAB/EgAA5B0AAEkJAADzAAAAWAwAAL0XAAAiAwAA
| hw4AAOwZAABRBQAAthAAABscAACABwAA5RIAAEoeAACvCQAAFBUAAHkAAADeCwAAQxcAAKgCAAANDgAAchkAANcEAAA8EAAA
| oRsAAAYHAABrEgAA0B0AADUJAACaFAAA/x8AAGQLAADJFgAALgIAAJMNAAD4GAAAXQQAAMIPAAAnGwAAjAYAAPERAABWHQAA
| uwgAACAUAACFHwAA6goAAE8WAAC0AQAAGQ0AAH4YAADjAwAASA8AAK0aAAASBgAAdxEAANwcAABBCAAAphMAAAsfAABwCgAA
| 1RUAADoBAACfDAAABBgAAGkDAADODgAAMxoAAJgFAAD9EAAAYhwAAMcHAAAsEwAAkR4AAPYJAABbFQAAwAAAACUMAACKFwAA
| 7wIAAFQOAAC5GQAAHgUAAIMQAADoGwAATQcAALISAAAXHgAAfAkAAOEUAABGAAAAqwsAABAXAAB1AgAA2g0AAD8ZAACkBAAA
| CRAAAG4bAADTBgAAOBIAAJ0dAAACCQAAZxQAAMwfAAAxCwAAlhYAAPsBAABgDQAAxRgAACoEAACPDwAA9BoAAFkGAAC+EQAA
| Ix0AAIgIAADtEwAAUh8AALcKAAAcFgAAgQEAAOYMAABLGAAAsAMAABUPAAB6GgAA3wUAAEQRAACpHAAADggAAHMTAADYHgAA
| PQoAAKIVAAAHAQAAbAwAANEXAAA2AwAAmw4AAAAaAABlBQAAyhAAAC8cAACUBwAA+RIAAF4eAADDCQAAKBUAAI0AAADyCwAA
| VxcAALwCAAAhDgAAhhkAAOsEAABQEAAAtRsAABoHAAB/EgAA5B0AAEkJAACuFAAAEwAAAHgLAADdFgAAQgIAAKcNAAAMGQAA
| cQQAANYPAAA7GwAAoAYAAAUSAABqHQAAzwgAADQUAACZHwAA/goAAGMWAADIAQAALQ0AAJIYAAD3AwAAXA8AAMEaAAAmBgAA
| ixEAAPAcAABVCAAAuhMAAB8fAACECgAA6RUAAE4BAACzDAAAGBgAAH0DAADiDgAARxoAAKwFAAAREQAAdhwAANsHAABAEwAA
| pR4AAAoKAABvFQAA1AAAADkMAACeFwAAAwMAAGgOAADNGQAAMgUAAJcQAAD8GwAAYQcAAMYSAAArHgAAkAkAAPUUAABaAAAA
| vwsAACQXAACJAgAA7g0AAFMZAAC4BAAAHRAAAIIbAADnBgAATBIAALEdAAAWCQAAexQAAOAfAABFCwAAqhYAAA8CAAB0DQAA
| 2RgAAD4EAACjDwAACBsAAG0GAADSEQAANx0AAJwIAAABFAAAZh8AAMsKAAAwFgAAlQEAAPoMAABfGAAAxAMAACkPAACOGgAA
| OBIAAJ0dAAACCQAAZxQAAMwfAAAxCwAAlhYAAPsBAABgDQAAxRgAACoEAACPDwAA9BoAAFkGAAC+EQAAIx0AAIgIAADtEwAA
| Uh8AALcKAAAcFgAAgQEAAOYMAABLGAAAsAMAABUPAAB6GgAA3wUAAEQRAACpHAAADggAAHMTAADYHgAAPQoAAKIVAAAHAQAA
| bAwAANEXAAA2AwAAmw4AAAAaAABlBQAAyhAAAC8cAACUBwAA+RIAAF4eAADDCQAAKBUAAI0AAADyCwAAVxcAALwCAAAhDgAA
| hhkAAOsEAABQEAAAtRsAABoHAAB/EgAA5B0AAEkJAACuFAAAEwAAAHgLAADdFgAAQgIAAKcNAAAMGQAAcQQAANYPAAA7GwAA
| oAYAAAUSAABqHQAAzwgAADQUAACZHwAA/goAAGMWAADIAQAALQ0AAJIYAAD3AwAAXA8AAMEaAAAmBgAAixEAAPAcAABVCAAA
| uhMAAB8fAACECgAA6RUAAE4BAACzDAAAGBgAAH0DAADiDgAARxoAAKwFAAAREQAAdhwAANsHAABAEwAApR4AAAoKAABvFQAA
| 1AAAADkMAACeFwAAAwMAAGgOAADNGQAAMgUAAJcQAAD8GwAAYQcAAMYSAAArHgAAkAkAAPUUAABaAAAAvwsAACQXAACJAgAA
| 7g0AAFMZAAC4BAAAHRAAAIIbAADnBgAATBIAALEdAAAWCQAAexQAAOAfAABFCwAAqhYAAA8CAAB0DQAA2RgAAD4EAACjDwAA
| CBsAAG0GAADSEQAANx0AAJwIAAABFAAAZh8AAMsKAAAwFgAAlQEAAPoMAABfGAAAxAMAACkPAACOGgAA8wUAAFgRAAC9HAAA
| IggAAIcTAADsHgAAUQoAALYVAAAbAQAAgAwAAOUXAABKAwAArw4AABQaAAB5BQAA3hAAAEMcAACoBwAADRMAAHIeAADXCQAA
| PBUAAKEAAAAGDAAAaxcAANACAAA1DgAAmhkAAP8EAABkEAAAyRsAAC4HAACTEgAA+B0AAF0JAADCFAAAJwAAAIwLAADxFgAA
| VgIAALsNAAAgGQAAhQQAAOoPAABPGwAAtAYAABkSAAB+HQAA4wgAAEgUAACtHwAAEgsAAHcWAADcAQAAQQ0AAKYYAAALBAAA
| cA8AANUaAAA6BgAAnxEAAAQdAABpCAAAzhMAADMfAACYCgAA/RUAAGIBAADHDAAALBgAAJEDAAD2DgAAWxoAAMAFAAAlEQAA
| ihwAAO8HAABUEwAAuR4AAB4KAACDFQAA6AAAAE0MAACyFwAAFwMAAHwOAADhGQAARgUAAKsQAAAQHAAAdQcAANoSAAA/HgAA
| pAkAAAkVAABuAAAA0wsAAH0DAADiDgAARxoAAKwFAAAREQAAdhwAANsHAABAEwAApR4AAAoKAABvFQAA1AAAADkMAACeFwAA
| AwMAAGgOAADNGQAAMgUAAJcQAAD8GwAAYQcAAMYSAAArHgAAkAkAAPUUAABaAAAAvwsAACQXAACJAgAA7g0AAFMZAAC4BAAA
| HRAAAIIbAADnBgAATBIAALEdAAAWCQAAexQAAOAfAABFCwAAqhYAAA8CAAB0DQAA2RgAAD4EAACjDwAACBsAAG0GAADSEQAA
| Nx0AAJwIAAABFAAAZh8AAMsKAAAwFgAAlQEAAPoMAABfGAAAxAMAACkPAACOGgAA8wUAAFgRAAC9HAAAIggAAIcTAADsHgAA
| UQoAALYVAAAbAQAAgAwAAOUXAABKAwAArw4AABQaAAB5BQAA3hAAAEMcAACoBwAADRMAAHIeAADXCQAAPBUAAKEAAAAGDAAA
| axcAANACAAA1DgAAmhkAAP8EAABkEAAAyRsAAC4HAACTEgAA+B0AAF0JAADCFAAAJwAAAIwLAADxFgAAVgIAALsNAAAgGQAA
| hQQAAOoPAABPGwAAtAYAABkSAAB+HQAA4wgAAEgUAACtHwAAEgsAAHcWAADcAQAAQQ0AAKYYAAALBAAAcA8AANUaAAA6BgAA
| nxEAAAQdAABpCAAAzhMAADMfAACYCgAA/RUAAGIBAADHDAAALBgAAJEDAAD2DgAAWxoAAMAFAAAlEQAAihwAAO8HAABUEwAA
| uR4AAB4KAACDFQAA6AAAAE0MAACyFwAAFwMAAHwOAADhGQAARgUAAKsQAAAQHAAAdQcAANoSAAA/HgAApAkAAAkVAABuAAAA
| 0wsAADgXAACdAgAAAg4AAGcZAADMBAAAMRAAAJYbAAD7BgAAYBIAAMUdAAAqCQAAjxQAAPQfAABZCwAAvhYAACMCAACIDQAA
| 7RgAAFIEAAC3DwAAHBsAAIEGAADmEQAASx0AALAIAAAVFAAAeh8AAN8KAABEFgAAqQEAAA4NAABzGAAA2AMAAD0PAACiGgAA
| BwYAAGwRAADRHAAANggAAJsTAAAAHwAAZQoAAMoVAAAvAQAAlAwAAPkXAABeAwAAww4AACgaAACNBQAA8hAAAFccAAC8BwAA
| IRMAAIYeAADrCQAAUBUAALUAAAAaDAAAfxcAAOQCAABJDgAArhkAABMFAAB4EAAA3RsAAEIHAACnEgAADB4AAHEJAADWFAAA
| OwAAAKALAAAFFwAAagIAAM8NAAA0GQAAmQQAAP4PAABjGwAAyAYAAC0SAACSHQAA9wgAAFwUAADBHwAAJgsAAIsWAADwAQAA
| VQ0AALoYAAAfBAAAhA8AAOkaAABOBgAAsxEAABgdAADCFAAAJwAAAIwLAADxFgAAVgIAALsNAAAgGQAAhQQAAOoPAABPGwAA
| tAYAABkSAAB+HQAA4wgAAEgUAACtHwAAEgsAAHcWAADcAQAAQQ0AAKYYAAALBAAAcA8AANUaAAA6BgAAnxEAAAQdAABpCAAA
| zhMAADMfAACYCgAA/RUAAGIBAADHDAAALBgAAJEDAAD2DgAAWxoAAMAFAAAlEQAAihwAAO8HAABUEwAAuR4AAB4KAACDFQAA
| 6AAAAE0MAACyFwAAFwMAAHwOAADhGQAARgUAAKsQAAAQHAAAdQcAANoSAAA/HgAApAkAAAkVAABuAAAA0wsAADgXAACdAgAA
| Ag4AAGcZAADMBAAAMRAAAJYbAAD7BgAAYBIAAMUdAAAqCQAAjxQAAPQfAABZCwAAvhYAACMCAACIDQAA7RgAAFIEAAC3DwAA
| HBsAAIEGAADmEQAASx0AALAIAAAVFAAAeh8AAN8KAABEFgAAqQEAAA4NAABzGAAA2AMAAD0PAACiGgAABwYAAGwRAADRHAAA
| NggAAJsTAAAAHwAAZQoAAMoVAAAvAQAAlAwAAPkXAABeAwAAww4AACgaAACNBQAA8hAAAFccAAC8BwAAIRMAAIYeAADrCQAA
| UBUAALUAAAAaDAAAfxcAAOQCAABJDgAArhkAABMFAAB4EAAA3RsAAEIHAACnEgAADB4AAHEJAADWFAAAOwAAAKALAAAFFwAA
| agIAAM8NAAA0GQAAmQQAAP4PAABjGwAAyAYAAC0SAACSHQAA9wgAAFwUAADBHwAAJgsAAIsWAADwAQAAVQ0AALoYAAAfBAAA
| hA8AAOkaAABOBgAAsxEAABgdAAB9CAAA4hMAAEcfAACsCgAAERYAAHYBAADbDAAAQBgAAKUDAAAKDwAAbxoAANQFAAA5EQAA
| nhwAAAMIAABoEwAAzR4AADIKAACXFQAA/AAAAGEMAADGFwAAKwMAAJAOAAD1GQAAWgUAAL8QAAAkHAAAiQcAAO4SAABTHgAA
| uAkAAB0VAACCAAAA5wsAAEwXAACxAgAAFg4AAHsZAADgBAAARRAAAKobAAAPBwAAdBIAANkdAAA+CQAAoxQAAAgAAABtCwAA
| 0hYAADcCAACcDQAAARkAAGYEAADLDwAAMBsAAJUGAAD6EQAAXx0AAMQIAAApFAAAjh8AAPMKAABYFgAAvQEAACINAACHGAAA
| 7AMAAFEPAAC2GgAAGwYAAIARAADlHAAASggAAK8TAAAUHwAAeQoAAN4VAABDAQAAqAwAAA0YAAByAwAA1w4AADwaAAChBQAA
| BhEAAGscAADQBwAANRMAAJoeAAD/CQAAZBUAAMkAAAAuDAAAkxcAAPgCAABdDgAABwYAAGwRAADRHAAANggAAJsTAAAAHwAA
| ZQoAAMoVAAAvAQAAlAwAAPkXAABeAwAAww4AACgaAACNBQAA8hAAAFccAAC8BwAAIRMAAIYeAADrCQAAUBUAALUAAAAaDAAA
| fxcAAOQCAABJDgAArhkAABMFAAB4EAAA3RsAAEIHAACnEgAADB4AAHEJAADWFAAAOwAAAKALAAAFFwAAagIAAM8NAAA0GQAA
| mQQAAP4PAABjGwAAyAYAAC0SAACSHQAA9wgAAFwUAADBHwAAJgsAAIsWAADwAQAAVQ0AALoYAAAfBAAAhA8AAOkaAABOBgAA
| sxEAABgdAAB9CAAA4hMAAEcfAACsCgAAERYAAHYBAADbDAAAQBgAAKUDAAAKDwAAbxoAANQFAAA5EQAAnhwAAAMIAABoEwAA
| zR4AADIKAACXFQAA/AAAAGEMAADGFwAAKwMAAJAOAAD1GQAAWgUAAL8QAAAkHAAAiQcAAO4SAABTHgAAuAkAAB0VAACCAAAA
| 5wsAAEwXAACxAgAAFg4AAHsZAADgBAAARRAAAKobAAAPBwAAdBIAANkdAAA+CQAAoxQAAAgAAABtCwAA0hYAADcCAACcDQAA
| ARkAAGYEAADLDwAAMBsAAJUGAAD6EQAAXx0AAMQIAAApFAAAjh8AAPMKAABYFgAAvQEAACINAACHGAAA7AMAAFEPAAC2GgAA
| GwYAAIARAADlHAAASggAAK8TAAAUHwAAeQoAAN4VAABDAQAAqAwAAA0YAAByAwAA1w4AADwaAAChBQAABhEAAGscAADQBwAA
| NRMAAJoeAAD/CQAAZBUAAMkAAAAuDAAAkxcAAPgCAABdDgAAwhkAACcFAACMEAAA8RsAAFYHAAC7EgAAIB4AAIUJAADqFAAA
| TwAAALQLAAAZFwAAfgIAAOMNAABIGQAArQQAABIQAAB3GwAA3AYAAEESAACmHQAACwkAAHAUAADVHwAAOgsAAJ8WAAAEAgAA
| aQ0AAM4YAAAzBAAAmA8AAP0aAABiBgAAxxEAACwdAACRCAAA9hMAAFsfAADACgAAJRYAAIoBAADvDAAAVBgAALkDAAAeDwAA
| gxoAAOgFAABNEQAAshwAABcIAAB8EwAA4R4AAEYKAACrFQAAEAEAAHUMAADaFwAAPwMAAKQOAAAJGgAAbgUAANMQAAA4HAAA
| nQcAAAITAABnHgAAzAkAADEVAACWAAAA+wsAAGAXAADFAgAAKg4AAI8ZAAD0BAAAWRAAAL4bAAAjBwAAiBIAAO0dAABSCQAA
| txQAABwAAACBCwAA5hYAAEsCAACwDQAAFRkAAHoEAADfDwAARBsAAKkGAAAOEgAAcx0AANgIAAA9FAAAoh8AAEwXAACxAgAA
| Fg4AAHsZAADgBAAARRAAAKobAAAPBwAAdBIAANkdAAA+CQAAoxQAAAgAAABtCwAA0hYAADcCAACcDQAAARkAAGYEAADLDwAA
| MBsAAJUGAAD6EQAAXx0AAMQIAAApFAAAjh8AAPMKAABYFgAAvQEAACINAACHGAAA7AMAAFEPAAC2GgAAGwYAAIARAADlHAAA
| SggAAK8TAAAUHwAAeQoAAN4VAABDAQAAqAwAAA0YAAByAwAA1w4AADwaAAChBQAABhEAAGscAADQBwAANRMAAJoeAAD/CQAA
| ZBUAAMkAAAAuDAAAkxcAAPgCAABdDgAAwhkAACcFAACMEAAA8RsAAFYHAAC7EgAAIB4AAIUJAADqFAAATwAAALQLAAAZFwAA
| fgIAAOMNAABIGQAArQQAABIQAAB3GwAA3AYAAEESAACmHQAACwkAAHAUAADVHwAAOgsAAJ8WAAAEAgAAaQ0AAM4YAAAzBAAA
| mA8AAP0aAABiBgAAxxEAACwdAACRCAAA9hMAAFsfAADACgAAJRYAAIoBAADvDAAAVBgAALkDAAAeDwAAgxoAAOgFAABNEQAA
| shwAABcIAAB8EwAA4R4AAEYKAACrFQAAEAEAAHUMAADaFwAAPwMAAKQOAAAJGgAAbgUAANMQAAA4HAAAnQcAAAITAABnHgAA
| zAkAADEVAACWAAAA+wsAAGAXAADFAgAAKg4AAI8ZAAD0BAAAWRAAAL4bAAAjBwAAiBIAAO0dAABSCQAAtxQAABwAAACBCwAA
| 5hYAAEsCAACwDQAAFRkAAHoEAADfDwAARBsAAKkGAAAOEgAAcx0AANgIAAA9FAAAoh8AAAcLAABsFgAA0QEAADYNAACbGAAA
| AAQAAGUPAADKGgAALwYAAJQRAAD5HAAAXggAAMMTAAAoHwAAjQoAAPIVAABXAQAAvAwAACEYAACGAwAA6w4AAFAaAAC1BQAA
| GhEAAH8cAADkBwAASRMAAK4eAAATCgAAeBUAAN0AAABCDAAApxcAAAwDAABxDgAA1hkAADsFAACgEAAABRwAAGoHAADPEgAA
| NB4AAJkJAAD+FAAAYwAAAMgLAAAtFwAAkgIAAPcNAABcGQAAwQQAACYQAACLGwAA8AYAAFUSAAC6HQAAHwkAAIQUAADpHwAA
| TgsAALMWAAAYAgAAfQ0AAOIYAABHBAAArA8AABEbAAB2BgAA2xEAAEAdAAClCAAAChQAAG8fAADUCgAAORYAAJ4BAAADDQAA
| aBgAAM0DAAAyDwAAlxoAAPwFAABhEQAAxhwAACsIAACQEwAA9R4AAFoKAAC/FQAAJAEAAIkMAADuFwAAUwMAALgOAAAdGgAA
| ggUAAOcQAACRCAAA9hMAAFsfAADACgAAJRYAAIoBAADvDAAAVBgAALkDAAAeDwAAgxoAAOgFAABNEQAAshwAABcIAAB8EwAA
| 4R4AAEYKAACrFQAAEAEAAHUMAADaFwAAPwMAAKQOAAAJGgAAbgUAANMQAAA4HAAAnQcAAAITAABnHgAAzAkAADEVAACWAAAA
| +wsAAGAXAADFAgAAKg4AAI8ZAAD0BAAAWRAAAL4bAAAjBwAAiBIAAO0dAABSCQAAtxQAABwAAACBCwAA5hYAAEsCAACwDQAA
| FRkAAHoEAADfDwAARBsAAKkGAAAOEgAAcx0AANgIAAA9FAAAoh8AAAcLAABsFgAA0QEAADYNAACbGAAAAAQAAGUPAADKGgAA
| LwYAAJQRAAD5HAAAXggAAMMTAAAoHwAAjQoAAPIVAABXAQAAvAwAACEYAACGAwAA6w4AAFAaAAC1BQAAGhEAAH8cAADkBwAA
| SRMAAK4eAAATCgAAeBUAAN0AAABCDAAApxcAAAwDAABxDgAA1hkAADsFAACgEAAABRwAAGoHAADPEgAANB4AAJkJAAD+FAAA
| YwAAAMgLAAAtFwAAkgIAAPcNAABcGQAAwQQAACYQAACLGwAA8AYAAFUSAAC6HQAAHwkAAIQUAADpHwAATgsAALMWAAAYAgAA
| fQ0AAOIYAABHBAAArA8AABEbAAB2BgAA2xEAAEAdAAClCAAAChQAAG8fAADUCgAAORYAAJ4BAAADDQAAaBgAAM0DAAAyDwAA
| lxoAAPwFAABhEQAAxhwAACsIAACQEwAA9R4AAFoKAAC/FQAAJAEAAIkMAADuFwAAUwMAALgOAAAdGgAAggUAAOcQAABMHAAA
| sQcAABYTAAB7HgAA4AkAAEUVAACqAAAADwwAAHQXAADZAgAAPg4AAKMZAAAIBQAAbRAAANIbAAA3BwAAnBIAAAEeAABmCQAA
| yxQAADAAAACVCwAA+hYAAF8CAADEDQAAKRkAAI4EAADzDwAAWBsAAL0GAAAiEgAAhx0AAOwIAABRFAAAth8AABsLAACAFgAA
| 5QEAAEoNAACvGAAAFAQAAHkPAADeGgAAQwYAAKgRAAANHQAAcggAANcTAAA8HwAAoQoAAAYWAABrAQAA0AwAADUYAACaAwAA
| /w4AAGQaAADJBQAALhEAAJMcAAD4BwAAXRMAAMIeAAAnCgAAjBUAAPEAAABWDAAAuxcAACADAACFDgAA6hkAAE8FAAC0EAAA
| GRwAAH4HAADjEgAASB4AAK0JAAASFQAAdwAAANwLAABBFwAApgIAAAsOAABwGQAA1QQAADoQAACfGwAABAcAAGkSAADOHQAA
| MwkAAJgUAAD9HwAAYgsAAMcWAAAsAgAA1hkAADsFAACgEAAABRwAAGoHAADPEgAANB4AAJkJAAD+FAAAYwAAAMgLAAAtFwAA
| kgIAAPcNAABcGQAAwQQAACYQAACLGwAA8AYAAFUSAAC6HQAAHwkAAIQUAADpHwAATgsAALMWAAAYAgAAfQ0AAOIYAABHBAAA
| rA8AABEbAAB2BgAA2xEAAEAdAAClCAAAChQAAG8fAADUCgAAORYAAJ4BAAADDQAAaBgAAM0DAAAyDwAAlxoAAPwFAABhEQAA
| xhwAACsIAACQEwAA9R4AAFoKAAC/FQAAJAEAAIkMAADuFwAAUwMAALgOAAAdGgAAggUAAOcQAABMHAAAsQcAABYTAAB7HgAA
| 4AkAAEUVAACqAAAADwwAAHQXAADZAgAAPg4AAKMZAAAIBQAAbRAAANIbAAA3BwAAnBIAAAEeAABmCQAAyxQAADAAAACVCwAA
| +hYAAF8CAADEDQAAKRkAAI4EAADzDwAAWBsAAL0GAAAiEgAAhx0AAOwIAABRFAAAth8AABsLAACAFgAA5QEAAEoNAACvGAAA
| FAQAAHkPAADeGgAAQwYAAKgRAAANHQAAcggAANcTAAA8HwAAoQoAAAYWAABrAQAA0AwAADUYAACaAwAA/w4AAGQaAADJBQAA
| LhEAAJMcAAD4BwAAXRMAAMIeAAAnCgAAjBUAAPEAAABWDAAAuxcAACADAACFDgAA6hkAAE8FAAC0EAAAGRwAAH4HAADjEgAA
| SB4AAK0JAAASFQAAdwAAANwLAABBFwAApgIAAAsOAABwGQAA1QQAADoQAACfGwAABAcAAGkSAADOHQAAMwkAAJgUAAD9HwAA
| YgsAAMcWAAAsAgAAkQ0AAPYYAABbBAAAwA8AACUbAACKBgAA7xEAAFQdAAC5CAAAHhQAAIMfAADoCgAATRYAALIBAAAXDQAA
| fBgAAOEDAABGDwAAqxoAABAGAAB1EQAA2hwAAD8IAACkEwAACR8AAG4KAADTFQAAOAEAAJ0MAAACGAAAZwMAAMwOAAAxGgAA
| lgUAAPsQAABgHAAAxQcAACoTAACPHgAA9AkAAFkVAAC+AAAAIwwAAIgXAADtAgAAUg4AALcZAAAcBQAAgRAAAOYbAABLBwAA
| sBIAABUeAAB6CQAA3xQAAEQAAACpCwAADhcAAHMCAADYDQAAPRkAAKIEAAAHEAAAbBsAANEGAAA2EgAAmx0AAAAJAABlFAAA
| yh8AAC8LAACUFgAA+QEAAF4NAADDGAAAKAQAAI0PAADyGgAAVwYAALwRAAAhHQAAhggAAOsTAABQHwAAtQoAABoWAAB/AQAA
| 5AwAAEkYAACuAwAAEw8AAHgaAADdBQAAQhEAAKccAAAMCAAAcRMAABsLAACAFgAA5QEAAEoNAACvGAAAFAQAAHkPAADeGgAA
| QwYAAKgRAAANHQAAcggAANcTAAA8HwAAoQoAAAYWAABrAQAA0AwAADUYAACaAwAA/w4AAGQaAADJBQAALhEAAJMcAAD4BwAA
| XRMAAMIeAAAnCgAAjBUAAPEAAABWDAAAuxcAACADAACFDgAA6hkAAE8FAAC0EAAAGRwAAH4HAADjEgAASB4AAK0JAAASFQAA
| dwAAANwLAABBFwAApgIAAAsOAABwGQAA1QQAADoQAACfGwAABAcAAGkSAADOHQAAMwkAAJgUAAD9HwAAYgsAAMcWAAAsAgAA
| kQ0AAPYYAABbBAAAwA8AACUbAACKBgAA7xEAAFQdAAC5CAAAHhQAAIMfAADoCgAATRYAALIBAAAXDQAAfBgAAOEDAABGDwAA
| qxoAABAGAAB1EQAA2hwAAD8IAACkEwAACR8AAG4KAADTFQAAOAEAAJ0MAAACGAAAZwMAAMwOAAAxGgAAlgUAAPsQAABgHAAA
| xQcAACoTAACPHgAA9AkAAFkVAAC+AAAAIwwAAIgXAADtAgAAUg4AALcZAAAcBQAAgRAAAOYbAABLBwAAsBIAABUeAAB6CQAA
| 3xQAAEQAAACpCwAADhcAAHMCAADYDQAAPRkAAKIEAAAHEAAAbBsAANEGAAA2EgAAmx0AAAAJAABlFAAAyh8AAC8LAACUFgAA
| +QEAAF4NAADDGAAAKAQAAI0PAADyGgAAVwYAALwRAAAhHQAAhggAAOsTAABQHwAAtQoAABoWAAB/AQAA5AwAAEkYAACuAwAA
| Ew8AAHgaAADdBQAAQhEAAKccAAAMCAAAcRMAANYeAAA7CgAAoBUAAAUBAABqDAAAzxcAADQDAACZDgAA/hkAAGMFAADIEAAA
| LRwAAJIHAAD3EgAAXB4AAMEJAAAmFQAAiwAAAPALAABVFwAAugIAAB8OAACEGQAA6QQAAE4QAACzGwAAGAcAAH0SAADiHQAA
| RwkAAKwUAAARAAAAdgsAANsWAABAAgAApQ0AAAoZAABvBAAA1A8AADkbAACeBgAAAxIAAGgdAADNCAAAMhQAAJcfAAD8CgAA
| YRYAAMYBAAArDQAAkBgAAPUDAABaDwAAvxoAACQGAACJEQAA7hwAAFMIAAC4EwAAHR8AAIIKAADnFQAATAEAALEMAAAWGAAA
| ewMAAOAOAABFGgAAqgUAAA8RAAB0HAAA2QcAAD4TAACjHgAACAoAAG0VAADSAAAANwwAAJwXAAABAwAAZg4AAMsZAAAwBQAA
| lRAAAPobAABfBwAAxBIAACkeAACOCQAA8xQAAFgAAAC9CwAAIhcAAIcCAADsDQAAURkAALYEAABgHAAAxQcAACoTAACPHgAA
| 9AkAAFkVAAC+AAAAIwwAAIgXAADtAgAAUg4AALcZAAAcBQAAgRAAAOYbAABLBwAAsBIAABUeAAB6CQAA3xQAAEQAAACpCwAA
| DhcAAHMCAADYDQAAPRkAAKIEAAAHEAAAbBsAANEGAAA2EgAAmx0AAAAJAABlFAAAyh8AAC8LAACUFgAA+QEAAF4NAADDGAAA
| KAQAAI0PAADyGgAAVwYAALwRAAAhHQAAhggAAOsTAABQHwAAtQoAABoWAAB/AQAA5AwAAEkYAACuAwAAEw8AAHgaAADdBQAA
| QhEAAKccAAAMCAAAcRMAANYeAAA7CgAAoBUAAAUBAABqDAAAzxcAADQDAACZDgAA/hkAAGMFAADIEAAALRwAAJIHAAD3EgAA
| XB4AAMEJAAAmFQAAiwAAAPALAABVFwAAugIAAB8OAACEGQAA6QQAAE4QAACzGwAAGAcAAH0SAADiHQAARwkAAKwUAAARAAAA
| dgsAANsWAABAAgAApQ0AAAoZAABvBAAA1A8AADkbAACeBgAAAxIAAGgdAADNCAAAMhQAAJcfAAD8CgAAYRYAAMYBAAArDQAA
| kBgAAPUDAABaDwAAvxoAACQGAACJEQAA7hwAAFMIAAC4EwAAHR8AAIIKAADnFQAATAEAALEMAAAWGAAAewMAAOAOAABFGgAA
| qgUAAA8RAAB0HAAA2QcAAD4TAACjHgAACAoAAG0VAADSAAAANwwAAJwXAAABAwAAZg4AAMsZAAAwBQAAlRAAAPobAABfBwAA
| xBIAACkeAACOCQAA8xQAAFgAAAC9CwAAIhcAAIcCAADsDQAAURkAALYEAAAbEAAAgBsAAOUGAABKEgAArx0AABQJAAB5FAAA
| 3h8AAEMLAACoFgAADQIAAHINAADXGAAAPAQAAKEPAAAGGwAAawYAANARAAA1HQAAmggAAP8TAABkHwAAyQoAAC4WAACTAQAA
| +AwAAF0YAADCAwAAJw8AAIwaAADxBQAAVhEAALscAAAgCAAAhRMAAOoeAABPCgAAtBUAABkBAAB+DAAA4xcAAEgDAACtDgAA
| EhoAAHcFAADcEAAAQRwAAKYHAAALEwAAcB4AANUJAAA6FQAAnwAAAAQMAABpFwAAzgIAADMOAACYGQAA/QQAAGIQAADHGwAA
| LAcAAJESAAD2HQAAWwkAAMAUAAAlAAAAigsAAO8WAABUAgAAuQ0AAB4ZAACDBAAA6A8AAE0bAACyBgAAFxIAAHwdAADhCAAA
| RhQAAKsfAAAQCwAAdRYAANoBAAA/DQAApBgAAAkEAABuDwAA0xoAADgGAACdEQAAAh0AAGcIAADMEwAAMR8AAJYKAAD7FQAA
| pQ0AAAoZAABvBAAA1A8AADkbAACeBgAAAxIAAGgdAADNCAAAMhQAAJcfAAD8CgAAYRYAAMYBAAArDQAAkBgAAPUDAABaDwAA
| vxoAACQGAACJEQAA7hwAAFMIAAC4EwAAHR8AAIIKAADnFQAATAEAALEMAAAWGAAAewMAAOAOAABFGgAAqgUAAA8RAAB0HAAA
| 2QcAAD4TAACjHgAACAoAAG0VAADSAAAANwwAAJwXAAABAwAAZg4AAMsZAAAwBQAAlRAAAPobAABfBwAAxBIAACkeAACOCQAA
| 8xQAAFgAAAC9CwAAIhcAAIcCAADsDQAAURkAALYEAAAbEAAAgBsAAOUGAABKEgAArx0AABQJAAB5FAAA3h8AAEMLAACoFgAA
| DQIAAHINAADXGAAAPAQAAKEPAAAGGwAAawYAANARAAA1HQAAmggAAP8TAABkHwAAyQoAAC4WAACTAQAA+AwAAF0YAADCAwAA
| Jw8AAIwaAADxBQAAVhEAALscAAAgCAAAhRMAAOoeAABPCgAAtBUAABkBAAB+DAAA4xcAAEgDAACtDgAAEhoAAHcFAADcEAAA
| QRwAAKYHAAALEwAAcB4AANUJAAA6FQAAnwAAAAQMAABpFwAAzgIAADMOAACYGQAA/QQAAGIQAADHGwAALAcAAJESAAD2HQAA
| WwkAAMAUAAAlAAAAigsAAO8WAABUAgAAuQ0AAB4ZAACDBAAA6A8AAE0bAACyBgAAFxIAAHwdAADhCAAARhQAAKsfAAAQCwAA
| dRYAANoBAAA/DQAApBgAAAkEAABuDwAA0xoAADgGAACdEQAAAh0AAGcIAADMEwAAMR8AAJYKAAD7FQAAYAEAAMUMAAAqGAAA
| jwMAAPQOAABZGgAAvgUAACMRAACIHAAA7QcAAFITAAC3HgAAHAoAAIEVAADmAAAASwwAALAXAAAVAwAAeg4AAN8ZAABEBQAA
| qRAAAA4cAABzBwAA2BIAAD0eAACiCQAABxUAAGwAAADRCwAANhcAAJsCAAAADgAAZRkAAMoEAAAvEAAAlBsAAPkGAABeEgAA
| wx0AACgJAACNFAAA8h8AAFcLAAC8FgAAIQIAAIYNAADrGAAAUAQAALUPAAAaGwAAfwYAAOQRAABJHQAArggAABMUAAB4HwAA
| 3QoAAEIWAACnAQAADA0AAHEYAADWAwAAOw8AAKAaAAAFBgAAahEAAM8cAAA0CAAAmRMAAP4eAABjCgAAyBUAAC0BAACSDAAA
| 9xcAAFwDAADBDgAAJhoAAIsFAADwEAAAVRwAALoHAAAfEwAAhB4AAOkJAABOFQAAswAAABgMAAB9FwAA4gIAAEcOAACsGQAA
| EQUAAHYQAADbGwAAQAcAAOoeAABPCgAAtBUAABkBAAB+DAAA4xcAAEgDAACtDgAAEhoAAHcFAADcEAAAQRwAAKYHAAALEwAA
| cB4AANUJAAA6FQAAnwAAAAQMAABpFwAAzgIAADMOAACYGQAA/QQAAGIQAADHGwAALAcAAJESAAD2HQAAWwkAAMAUAAAlAAAA
| igsAAO8WAABUAgAAuQ0AAB4ZAACDBAAA6A8AAE0bAACyBgAAFxIAAHwdAADhCAAARhQAAKsfAAAQCwAAdRYAANoBAAA/DQAA
| pBgAAAkEAABuDwAA0xoAADgGAACdEQAAAh0AAGcIAADMEwAAMR8AAJYKAAD7FQAAYAEAAMUMAAAqGAAAjwMAAPQOAABZGgAA
| vgUAACMRAACIHAAA7QcAAFITAAC3HgAAHAoAAIEVAADmAAAASwwAALAXAAAVAwAAeg4AAN8ZAABEBQAAqRAAAA4cAABzBwAA
| 2BIAAD0eAACiCQAABxUAAGwAAADRCwAANhcAAJsCAAAADgAAZRkAAMoEAAAvEAAAlBsAAPkGAABeEgAAwx0AACgJAACNFAAA
| 8h8AAFcLAAC8FgAAIQIAAIYNAADrGAAAUAQAALUPAAAaGwAAfwYAAOQRAABJHQAArggAABMUAAB4HwAA3QoAAEIWAACnAQAA
| DA0AAHEYAADWAwAAOw8AAKAaAAAFBgAAahEAAM8cAAA0CAAAmRMAAP4eAABjCgAAyBUAAC0BAACSDAAA9xcAAFwDAADBDgAA
| JhoAAIsFAADwEAAAVRwAALoHAAAfEwAAhB4AAOkJAABOFQAAswAAABgMAAB9FwAA4gIAAEcOAACsGQAAEQUAAHYQAADbGwAA
| QAcAAKUSAAAKHgAAbwkAANQUAAA5AAAAngsAAAMXAABoAgAAzQ0AADIZAACXBAAA/A8AAGEbAADGBgAAKxIAAJAdAAD1CAAA
| WhQAAL8fAAAkCwAAiRYAAO4BAABTDQAAuBgAAB0EAACCDwAA5xoAAEwGAACxEQAAFh0AAHsIAADgEwAARR8AAKoKAAAPFgAA
| dAEAANkMAAA+GAAAowMAAAgPAABtGgAA0gUAADcRAACcHAAAAQgAAGYTAADLHgAAMAoAAJUVAAD6AAAAXwwAAMQXAAApAwAA
| jg4AAPMZAABYBQAAvRAAACIcAACHBwAA7BIAAFEeAAC2CQAAGxUAAIAAAADlCwAAShcAAK8CAAAUDgAAeRkAAN4EAABDEAAA
| qBsAAA0HAAByEgAA1x0AADwJAAChFAAABgAAAGsLAADQFgAANQIAAJoNAAD/GAAAZAQAAMkPAAAuGwAAkwYAAPgRAABdHQAA
| wggAACcUAACMHwAA8QoAAFYWAAC7AQAAIA0AAIUYAAAvEAAAlBsAAPkGAABeEgAAwx0AACgJAACNFAAA8h8AAFcLAAC8FgAA
| IQIAAIYNAADrGAAAUAQAALUPAAAaGwAAfwYAAOQRAABJHQAArggAABMUAAB4HwAA3QoAAEIWAACnAQAADA0AAHEYAADWAwAA
| Ow8AAKAaAAAFBgAAahEAAM8cAAA0CAAAmRMAAP4eAABjCgAAyBUAAC0BAACSDAAA9xcAAFwDAADBDgAAJhoAAIsFAADwEAAA
| VRwAALoHAAAfEwAAhB4AAOkJAABOFQAAswAAABgMAAB9FwAA4gIAAEcOAACsGQAAEQUAAHYQAADbGwAAQAcAAKUSAAAKHgAA
| bwkAANQUAAA5AAAAngsAAAMXAABoAgAAzQ0AADIZAACXBAAA/A8AAGEbAADGBgAAKxIAAJAdAAD1CAAAWhQAAL8fAAAkCwAA
| iRYAAO4BAABTDQAAuBgAAB0EAACCDwAA5xoAAEwGAACxEQAAFh0AAHsIAADgEwAARR8AAKoKAAAPFgAAdAEAANkMAAA+GAAA
| owMAAAgPAABtGgAA0gUAADcRAACcHAAAAQgAAGYTAADLHgAAMAoAAJUVAAD6AAAAXwwAAMQXAAApAwAAjg4AAPMZAABYBQAA
| vRAAACIcAACHBwAA7BIAAFEeAAC2CQAAGxUAAIAAAADlCwAAShcAAK8CAAAUDgAAeRkAAN4EAABDEAAAqBsAAA0HAAByEgAA
| 1x0AADwJAAChFAAABgAAAGsLAADQFgAANQIAAJoNAAD/GAAAZAQAAMkPAAAuGwAAkwYAAPgRAABdHQAAwggAACcUAACMHwAA
| 8QoAAFYWAAC7AQAAIA0AAIUYAADqAwAATw8AALQaAAAZBgAAfhEAAOMcAABICAAArRMAABIfAAB3CgAA3BUAAEEBAACmDAAA
| CxgAAHADAADVDgAAOhoAAJ8FAAAEEQAAaRwAAM4HAAAzEwAAmB4AAP0JAABiFQAAxwAAACwMAACRFwAA9gIAAFsOAADAGQAA
| JQUAAIoQAADvGwAAVAcAALkSAAAeHgAAgwkAAOgUAABNAAAAsgsAABcXAAB8AgAA4Q0AAEYZAACrBAAAEBAAAHUbAADaBgAA
| PxIAAKQdAAAJCQAAbhQAANMfAAA4CwAAnRYAAAICAABnDQAAzBgAADEEAACWDwAA+xoAAGAGAADFEQAAKh0AAI8IAAD0EwAA
| WR8AAL4KAAAjFgAAiAEAAO0MAABSGAAAtwMAABwPAACBGgAA5gUAAEsRAACwHAAAFQgAAHoTAADfHgAARAoAAKkVAAAOAQAA
| cwwAANgXAAA9AwAAog4AAAcaAABsBQAA0RAAADYcAACbBwAAABMAAGUeAADKCQAAdAEAANkMAAA+GAAAowMAAAgPAABtGgAA
| 0gUAADcRAACcHAAAAQgAAGYTAADLHgAAMAoAAJUVAAD6AAAAXwwAAMQXAAApAwAAjg4AAPMZAABYBQAAvRAAACIcAACHBwAA
| 7BIAAFEeAAC2CQAAGxUAAIAAAADlCwAAShcAAK8CAAAUDgAAeRkAAN4EAABDEAAAqBsAAA0HAAByEgAA1x0AADwJAAChFAAA
| BgAAAGsLAADQFgAANQIAAJoNAAD/GAAAZAQAAMkPAAAuGwAAkwYAAPgRAABdHQAAwggAACcUAACMHwAA8QoAAFYWAAC7AQAA
| IA0AAIUYAADqAwAATw8AALQaAAAZBgAAfhEAAOMcAABICAAArRMAABIfAAB3CgAA3BUAAEEBAACmDAAACxgAAHADAADVDgAA
| OhoAAJ8FAAAEEQAAaRwAAM4HAAAzEwAAmB4AAP0JAABiFQAAxwAAACwMAACRFwAA9gIAAFsOAADAGQAAJQUAAIoQAADvGwAA
| VAcAALkSAAAeHgAAgwkAAOgUAABNAAAAsgsAABcXAAB8AgAA4Q0AAEYZAACrBAAAEBAAAHUbAADaBgAAPxIAAKQdAAAJCQAA
| bhQAANMfAAA4CwAAnRYAAAICAABnDQAAzBgAADEEAACWDwAA+xoAAGAGAADFEQAAKh0AAI8IAAD0EwAAWR8AAL4KAAAjFgAA
| iAEAAO0MAABSGAAAtwMAABwPAACBGgAA5gUAAEsRAACwHAAAFQgAAHoTAADfHgAARAoAAKkVAAAOAQAAcwwAANgXAAA9AwAA
| og4AAAcaAABsBQAA0RAAADYcAACbBwAAABMAAGUeAADKCQAALxUAAJQAAAD5CwAAXhcAAMMCAAAoDgAAjRkAAPIEAABXEAAA
| vBsAACEHAACGEgAA6x0AAFAJAAC1FAAAGgAAAH8LAADkFgAASQIAAK4NAAATGQAAeAQAAN0PAABCGwAApwYAAAwSAABxHQAA
| 1ggAADsUAACgHwAABQsAAGoWAADPAQAANA0AAJkYAAD+AwAAYw8AAMgaAAAtBgAAkhEAAPccAABcCAAAwRMAACYfAACLCgAA
| 8BUAAFUBAAC6DAAAHxgAAIQDAADpDgAAThoAALMFAAAYEQAAfRwAAOIHAABHEwAArB4AABEKAAB2FQAA2wAAAEAMAAClFwAA
| CgMAAG8OAADUGQAAOQUAAJ4QAAADHAAAaAcAAM0SAAAyHgAAlwkAAPwUAABhAAAAxgsAACsXAACQAgAA9Q0AAFoZAAC/BAAA
| JBAAAIkbAADuBgAAUxIAALgdAAAdCQAAghQAAOcfAABMCwAAsRYAABYCAAB7DQAA4BgAAEUEAACqDwAADxsAALkSAAAeHgAA
| gwkAAOgUAABNAAAAsgsAABcXAAB8AgAA4Q0AAEYZAACrBAAAEBAAAHUbAADaBgAAPxIAAKQdAAAJCQAAbhQAANMfAAA4CwAA
| nRYAAAICAABnDQAAzBgAADEEAACWDwAA+xoAAGAGAADFEQAAKh0AAI8IAAD0EwAAWR8AAL4KAAAjFgAAiAEAAO0MAABSGAAA
| twMAABwPAACBGgAA5gUAAEsRAACwHAAAFQgAAHoTAADfHgAARAoAAKkVAAAOAQAAcwwAANgXAAA9AwAAog4AAAcaAABsBQAA
| 0RAAADYcAACbBwAAABMAAGUeAADKCQAALxUAAJQAAAD5CwAAXhcAAMMCAAAoDgAAjRkAAPIEAABXEAAAvBsAACEHAACGEgAA
| 6x0AAFAJAAC1FAAAGgAAAH8LAADkFgAASQIAAK4NAAATGQAAeAQAAN0PAABCGwAApwYAAAwSAABxHQAA1ggAADsUAACgHwAA
| BQsAAGoWAADPAQAANA0AAJkYAAD+AwAAYw8AAMgaAAAtBgAAkhEAAPccAABcCAAAwRMAACYfAACLCgAA8BUAAFUBAAC6DAAA
| HxgAAIQDAADpDgAAThoAALMFAAAYEQAAfRwAAOIHAABHEwAArB4AABEKAAB2FQAA2wAAAEAMAAClFwAACgMAAG8OAADUGQAA
| OQUAAJ4QAAADHAAAaAcAAM0SAAAyHgAAlwkAAPwUAABhAAAAxgsAACsXAACQAgAA9Q0AAFoZAAC/BAAAJBAAAIkbAADuBgAA
| UxIAALgdAAAdCQAAghQAAOcfAABMCwAAsRYAABYCAAB7DQAA4BgAAEUEAACqDwAADxsAAHQGAADZEQAAPh0AAKMIAAAIFAAA
| bR8AANIKAAA3FgAAnAEAAAENAABmGAAAywMAADAPAACVGgAA+gUAAF8RAADEHAAAKQgAAI4TAADzHgAAWAoAAL0VAAAiAQAA
| hwwAAOwXAABRAwAAtg4AABsaAACABQAA5RAAAEocAACvBwAAFBMAAHkeAADeCQAAQxUAAKgAAAANDAAAchcAANcCAAA8DgAA
| oRkAAAYFAABrEAAA0BsAADUHAACaEgAA/x0AAGQJAADJFAAALgAAAJMLAAD4FgAAXQIAAMINAAAnGQAAjAQAAPEPAABWGwAA
| uwYAACASAACFHQAA6ggAAE8UAAC0HwAAGQsAAH4WAADjAQAASA0AAK0YAAASBAAAdw8AANwaAABBBgAAphEAAAsdAABwCAAA
| 1RMAADofAACfCgAABBYAAGkBAADODAAAMxgAAJgDAAD9DgAAYhoAAMcFAAAsEQAAkRwAAPYHAABbEwAAwB4AACUKAACKFQAA
| 7wAAAFQMAAD+AwAAYw8AAMgaAAAtBgAAkhEAAPccAABcCAAAwRMAACYfAACLCgAA8BUAAFUBAAC6DAAAHxgAAIQDAADpDgAA
| ThoAALMFAAAYEQAAfRwAAOIHAABHEwAArB4AABEKAAB2FQAA2wAAAEAMAAClFwAACgMAAG8OAADUGQAAOQUAAJ4QAAADHAAA
| aAcAAM0SAAAyHgAAlwkAAPwUAABhAAAAxgsAACsXAACQAgAA9Q0AAFoZAAC/BAAAJBAAAIkbAADuBgAAUxIAALgdAAAdCQAA
| ghQAAOcfAABMCwAAsRYAABYCAAB7DQAA4BgAAEUEAACqDwAADxsAAHQGAADZEQAAPh0AAKMIAAAIFAAAbR8AANIKAAA3FgAA
| nAEAAAENAABmGAAAywMAADAPAACVGgAA+gUAAF8RAADEHAAAKQgAAI4TAADzHgAAWAoAAL0VAAAiAQAAhwwAAOwXAABRAwAA
| tg4AABsaAACABQAA5RAAAEocAACvBwAAFBMAAHkeAADeCQAAQxUAAKgAAAANDAAAchcAANcCAAA8DgAAoRkAAAYFAABrEAAA
| 0BsAADUHAACaEgAA/x0AAGQJAADJFAAALgAAAJMLAAD4FgAAXQIAAMINAAAnGQAAjAQAAPEPAABWGwAAuwYAACASAACFHQAA
| 6ggAAE8UAAC0HwAAGQsAAH4WAADjAQAASA0AAK0YAAASBAAAdw8AANwaAABBBgAAphEAAAsdAABwCAAA1RMAADofAACfCgAA
| BBYAAGkBAADODAAAMxgAAJgDAAD9DgAAYhoAAMcFAAAsEQAAkRwAAPYHAABbEwAAwB4AACUKAACKFQAA7wAAAFQMAAC5FwAA
| HgMAAIMOAADoGQAATQUAALIQAAAXHAAAfAcAAOESAABGHgAAqwkAABAVAAB1AAAA2gsAAD8XAACkAgAACQ4AAG4ZAADTBAAA
| OBAAAJ0bAAACBwAAZxIAAMwdAAAxCQAAlhQAAPsfAABgCwAAxRYAACoCAACPDQAA9BgAAFkEAAC+DwAAIxsAAIgGAADtEQAA
| Uh0AALcIAAAcFAAAgR8AAOYKAABLFgAAsAEAABUNAAB6GAAA3wMAAEQPAACpGgAADgYAAHMRAADYHAAAPQgAAKITAAAHHwAA
| bAoAANEVAAA2AQAAmwwAAAAYAABlAwAAyg4AAC8aAACUBQAA+RAAAF4cAADDBwAAKBMAAI0eAADyCQAAVxUAALwAAAAhDAAA
| hhcAAOsCAABQDgAAtRkAABoFAAB/EAAA5BsAAEkHAACuEgAAEx4AAHgJAADdFAAAQgAAAKcLAAAMFwAAcQIAANYNAAA7GQAA
| oAQAAAUQAABqGwAAzwYAADQSAACZHQAAQxUAAKgAAAANDAAAchcAANcCAAA8DgAAoRkAAAYFAABrEAAA0BsAADUHAACaEgAA
| /x0AAGQJAADJFAAALgAAAJMLAAD4FgAAXQIAAMINAAAnGQAAjAQAAPEPAABWGwAAuwYAACASAACFHQAA6ggAAE8UAAC0HwAA
| GQsAAH4WAADjAQAASA0AAK0YAAASBAAAdw8AANwaAABBBgAAphEAAAsdAABwCAAA1RMAADofAACfCgAABBYAAGkBAADODAAA
| MxgAAJgDAAD9DgAAYhoAAMcFAAAsEQAAkRwAAPYHAABbEwAAwB4AACUKAACKFQAA7wAAAFQMAAC5FwAAHgMAAIMOAADoGQAA
| TQUAALIQAAAXHAAAfAcAAOESAABGHgAAqwkAABAVAAB1AAAA2gsAAD8XAACkAgAACQ4AAG4ZAADTBAAAOBAAAJ0bAAACBwAA
| ZxIAAMwdAAAxCQAAlhQAAPsfAABgCwAAxRYAACoCAACPDQAA9BgAAFkEAAC+DwAAIxsAAIgGAADtEQAAUh0AALcIAAAcFAAA
| gR8AAOYKAABLFgAAsAEAABUNAAB6GAAA3wMAAEQPAACpGgAADgYAAHMRAADYHAAAPQgAAKITAAAHHwAAbAoAANEVAAA2AQAA
| mwwAAAAYAABlAwAAyg4AAC8aAACUBQAA+RAAAF4cAADDBwAAKBMAAI0eAADyCQAAVxUAALwAAAAhDAAAhhcAAOsCAABQDgAA
| tRkAABoFAAB/EAAA5BsAAEkHAACuEgAAEx4AAHgJAADdFAAAQgAAAKcLAAAMFwAAcQIAANYNAAA7GQAAoAQAAAUQAABqGwAA
| zwYAADQSAACZHQAA/ggAAGMUAADIHwAALQsAAJIWAAD3AQAAXA0AAMEYAAAmBAAAiw8AAPAaAABVBgAAuhEAAB8dAACECAAA
| 6RMAAE4fAACzCgAAGBYAAH0BAADiDAAARxgAAKwDAAARDwAAdhoAANsFAABAEQAApRwAAAoIAABvEwAA1B4AADkKAACeFQAA
| AwEAAGgMAADNFwAAMgMAAJcOAAD8GQAAYQUAAMYQAAArHAAAkAcAAPUSAABaHgAAvwkAACQVAACJAAAA7gsAAFMXAAC4AgAA
| HQ4AAIIZAADnBAAATBAAALEbAAAWBwAAexIAAOAdAABFCQAAqhQAAA8AAAB0CwAA2RYAAD4CAACjDQAACBkAAG0EAADSDwAA
| NxsAAJwGAAABEgAAZh0AAMsIAAAwFAAAlR8AAPoKAABfFgAAxAEAACkNAACOGAAA8wMAAFgPAAC9GgAAIgYAAIcRAADsHAAA
| UQgAALYTAAAbHwAAgAoAAOUVAABKAQAArwwAABQYAAB5AwAA3g4AAIgGAADtEQAAUh0AALcIAAAcFAAAgR8AAOYKAABLFgAA
| sAEAABUNAAB6GAAA3wMAAEQPAACpGgAADgYAAHMRAADYHAAAPQgAAKITAAAHHwAAbAoAANEVAAA2AQAAmwwAAAAYAABlAwAA
| yg4AAC8aAACUBQAA+RAAAF4cAADDBwAAKBMAAI0eAADyCQAAVxUAALwAAAAhDAAAhhcAAOsCAABQDgAAtRkAABoFAAB/EAAA
| 5BsAAEkHAACuEgAAEx4AAHgJAADdFAAAQgAAAKcLAAAMFwAAcQIAANYNAAA7GQAAoAQAAAUQAABqGwAAzwYAADQSAACZHQAA
| /ggAAGMUAADIHwAALQsAAJIWAAD3AQAAXA0AAMEYAAAmBAAAiw8AAPAaAABVBgAAuhEAAB8dAACECAAA6RMAAE4fAACzCgAA
| GBYAAH0BAADiDAAARxgAAKwDAAARDwAAdhoAANsFAABAEQAApRwAAAoIAABvEwAA1B4AADkKAACeFQAAAwEAAGgMAADNFwAA
| MgMAAJcOAAD8GQAAYQUAAMYQAAArHAAAkAcAAPUSAABaHgAAvwkAACQVAACJAAAA7gsAAFMXAAC4AgAAHQ4AAIIZAADnBAAA
| TBAAALEbAAAWBwAAexIAAOAdAABFCQAAqhQAAA8AAAB0CwAA2RYAAD4CAACjDQAACBkAAG0EAADSDwAANxsAAJwGAAABEgAA
| Zh0AAMsIAAAwFAAAlR8AAPoKAABfFgAAxAEAACkNAACOGAAA8wMAAFgPAAC9GgAAIgYAAIcRAADsHAAAUQgAALYTAAAbHwAA
| gAoAAOUVAABKAQAArwwAABQYAAB5AwAA3g4AAEMaAACoBQAADREAAHIcAADXBwAAPBMAAKEeAAAGCgAAaxUAANAAAAA1DAAA
| mhcAAP8CAABkDgAAyRkAAC4FAACTEAAA+BsAAF0HAADCEgAAJx4AAIwJAADxFAAAVgAAALsLAAAgFwAAhQIAAOoNAABPGQAA
| tAQAABkQAAB+GwAA4wYAAEgSAACtHQAAEgkAAHcUAADcHwAAQQsAAKYWAAALAgAAcA0AANUYAAA6BAAAnw8AAAQbAABpBgAA
| zhEAADMdAACYCAAA/RMAAGIfAADHCgAALBYAAJEBAAD2DAAAWxgAAMADAAAlDwAAihoAAO8FAABUEQAAuRwAAB4IAACDEwAA
| 6B4AAE0KAACyFQAAFwEAAHwMAADhFwAARgMAAKsOAAAQGgAAdQUAANoQAAA/HAAApAcAAAkTAABuHgAA0wkAADgVAACdAAAA
| AgwAAGcXAADMAgAAMQ4AAJYZAAD7BAAAYBAAAMUbAAAqBwAAjxIAAPQdAABZCQAAvhQAACMAAADNFwAAMgMAAJcOAAD8GQAA
| YQUAAMYQAAArHAAAkAcAAPUSAABaHgAAvwkAACQVAACJAAAA7gsAAFMXAAC4AgAAHQ4AAIIZAADnBAAATBAAALEbAAAWBwAA
| exIAAOAdAABFCQAAqhQAAA8AAAB0CwAA2RYAAD4CAACjDQAACBkAAG0EAADSDwAANxsAAJwGAAABEgAAZh0AAMsIAAAwFAAA
| lR8AAPoKAABfFgAAxAEAACkNAACOGAAA8wMAAFgPAAC9GgAAIgYAAIcRAADsHAAAUQgAALYTAAAbHwAAgAoAAOUVAABKAQAA
| rwwAABQYAAB5AwAA3g4AAEMaAACoBQAADREAAHIcAADXBwAAPBMAAKEeAAAGCgAAaxUAANAAAAA1DAAAmhcAAP8CAABkDgAA
| yRkAAC4FAACTEAAA+BsAAF0HAADCEgAAJx4AAIwJAADxFAAAVgAAALsLAAAgFwAAhQIAAOoNAABPGQAAtAQAABkQAAB+GwAA
| 4wYAAEgSAACtHQAAEgkAAHcUAADcHwAAQQsAAKYWAAALAgAAcA0AANUYAAA6BAAAnw8AAAQbAABpBgAAzhEAADMdAACYCAAA
| /RMAAGIfAADHCgAALBYAAJEBAAD2DAAAWxgAAMADAAAlDwAAihoAAO8FAABUEQAAuRwAAB4IAACDEwAA6B4AAE0KAACyFQAA
| FwEAAHwMAADhFwAARgMAAKsOAAAQGgAAdQUAANoQAAA/HAAApAcAAAkTAABuHgAA0wkAADgVAACdAAAAAgwAAGcXAADMAgAA
| MQ4AAJYZAAD7BAAAYBAAAMUbAAAqBwAAjxIAAPQdAABZCQAAvhQAACMAAACICwAA7RYAAFICAAC3DQAAHBkAAIEEAADmDwAA
| SxsAALAGAAAVEgAAeh0AAN8IAABEFAAAqR8AAA4LAABzFgAA2AEAAD0NAACiGAAABwQAAGwPAADRGgAANgYAAJsRAAAAHQAA
| ZQgAAMoTAAAvHwAAlAoAAPkVAABeAQAAwwwAACgYAACNAwAA8g4AAFcaAAC8BQAAIREAAIYcAADrBwAAUBMAALUeAAAaCgAA
| fxUAAOQAAABJDAAArhcAABMDAAB4DgAA3RkAAEIFAACnEAAADBwAAHEHAADWEgAAOx4AAKAJAAAFFQAAagAAAM8LAAA0FwAA
| mQIAAP4NAABjGQAAyAQAAC0QAACSGwAA9wYAAFwSAADBHQAAJgkAAIsUAADwHwAAVQsAALoWAAAfAgAAhA0AAOkYAABOBAAA
| sw8AABgbAAB9BgAA4hEAAEcdAACsCAAAERQAAHYfAADbCgAAQBYAAKUBAAAKDQAAbxgAANQDAAA5DwAAnhoAAAMGAABoEQAA
| EgkAAHcUAADcHwAAQQsAAKYWAAALAgAAcA0AANUYAAA6BAAAnw8AAAQbAABpBgAAzhEAADMdAACYCAAA/RMAAGIfAADHCgAA
| LBYAAJEBAAD2DAAAWxgAAMADAAAlDwAAihoAAO8FAABUEQAAuRwAAB4IAACDEwAA6B4AAE0KAACyFQAAFwEAAHwMAADhFwAA
| RgMAAKsOAAAQGgAAdQUAANoQAAA/HAAApAcAAAkTAABuHgAA0wkAADgVAACdAAAAAgwAAGcXAADMAgAAMQ4AAJYZAAD7BAAA
| YBAAAMUbAAAqBwAAjxIAAPQdAABZCQAAvhQAACMAAACICwAA7RYAAFICAAC3DQAAHBkAAIEEAADmDwAASxsAALAGAAAVEgAA
| eh0AAN8IAABEFAAAqR8AAA4LAABzFgAA2AEAAD0NAACiGAAABwQAAGwPAADRGgAANgYAAJsRAAAAHQAAZQgAAMoTAAAvHwAA
| lAoAAPkVAABeAQAAwwwAACgYAACNAwAA8g4AAFcaAAC8BQAAIREAAIYcAADrBwAAUBMAALUeAAAaCgAAfxUAAOQAAABJDAAA
| rhcAABMDAAB4DgAA3RkAAEIFAACnEAAADBwAAHEHAADWEgAAOx4AAKAJAAAFFQAAagAAAM8LAAA0FwAAmQIAAP4NAABjGQAA
| yAQAAC0QAACSGwAA9wYAAFwSAADBHQAAJgkAAIsUAADwHwAAVQsAALoWAAAfAgAAhA0AAOkYAABOBAAAsw8AABgbAAB9BgAA
| 4hEAAEcdAACsCAAAERQAAHYfAADbCgAAQBYAAKUBAAAKDQAAbxgAANQDAAA5DwAAnhoAAAMGAABoEQAAzRwAADIIAACXEwAA
| /B4AAGEKAADGFQAAKwEAAJAMAAD1FwAAWgMAAL8OAAAkGgAAiQUAAO4QAABTHAAAuAcAAB0TAACCHgAA5wkAAEwVAACxAAAA
| FgwAAHsXAADgAgAARQ4AAKoZAAAPBQAAdBAAANkbAAA+BwAAoxIAAAgeAABtCQAA0hQAADcAAACcCwAAARcAAGYCAADLDQAA
| MBkAAJUEAAD6DwAAXxsAAMQGAAApEgAAjh0AAPMIAABYFAAAvR8AACILAACHFgAA7AEAAFENAAC2GAAAGwQAAIAPAADlGgAA
| SgYAAK8RAAAUHQAAeQgAAN4TAABDHwAAqAoAAA0WAAByAQAA1wwAADwYAAChAwAABg8AAGsaAADQBQAANREAAJocAAD/BwAA
| ZBMAAMkeAAAuCgAAkxUAAPgAAABdDAAAwhcAACcDAACMDgAA8RkAAFYFAAC7EAAAIBwAAIUHAADqEgAATx4AALQJAAAZFQAA
| fgAAAOMLAABIFwAArQIAAFcaAAC8BQAAIREAAIYcAADrBwAAUBMAALUeAAAaCgAAfxUAAOQAAABJDAAArhcAABMDAAB4DgAA
| 3RkAAEIFAACnEAAADBwAAHEHAADWEgAAOx4AAKAJAAAFFQAAagAAAM8LAAA0FwAAmQIAAP4NAABjGQAAyAQAAC0QAACSGwAA
| 9wYAAFwSAADBHQAAJgkAAIsUAADwHwAAVQsAALoWAAAfAgAAhA0AAOkYAABOBAAAsw8AABgbAAB9BgAA4hEAAEcdAACsCAAA
| ERQAAHYfAADbCgAAQBYAAKUBAAAKDQAAbxgAANQDAAA5DwAAnhoAAAMGAABoEQAAzRwAADIIAACXEwAA/B4AAGEKAADGFQAA
| KwEAAJAMAAD1FwAAWgMAAL8OAAAkGgAAiQUAAO4QAABTHAAAuAcAAB0TAACCHgAA5wkAAEwVAACxAAAAFgwAAHsXAADgAgAA
| RQ4AAKoZAAAPBQAAdBAAANkbAAA+BwAAoxIAAAgeAABtCQAA0hQAADcAAACcCwAAARcAAGYCAADLDQAAMBkAAJUEAAD6DwAA
| XxsAAMQGAAApEgAAjh0AAPMIAABYFAAAvR8AACILAACHFgAA7AEAAFENAAC2GAAAGwQAAIAPAADlGgAASgYAAK8RAAAUHQAA
| eQgAAN4TAABDHwAAqAoAAA0WAAByAQAA1wwAADwYAAChAwAABg8AAGsaAADQBQAANREAAJocAAD/BwAAZBMAAMkeAAAuCgAA
| kxUAAPgAAABdDAAAwhcAACcDAACMDgAA8RkAAFYFAAC7EAAAIBwAAIUHAADqEgAATx4AALQJAAAZFQAAfgAAAOMLAABIFwAA
| rQIAABIOAAB3GQAA3AQAAEEQAACmGwAACwcAAHASAADVHQAAOgkAAJ8UAAAEAAAAaQsAAM4WAAAzAgAAmA0AAP0YAABiBAAA
| xw8AACwbAACRBgAA9hEAAFsdAADACAAAJRQAAIofAADvCgAAVBYAALkBAAAeDQAAgxgAAOgDAABNDwAAshoAABcGAAB8EQAA
| 4RwAAEYIAACrEwAAEB8AAHUKAADaFQAAPwEAAKQMAAAJGAAAbgMAANMOAAA4GgAAnQUAAAIRAABnHAAAzAcAADETAACWHgAA
| +wkAAGAVAADFAAAAKgwAAI8XAAD0AgAAWQ4AAL4ZAAAjBQAAiBAAAO0bAABSBwAAtxIAABweAACBCQAA5hQAAEsAAACwCwAA
| FRcAAHoCAADfDQAARBkAAKkEAAAOEAAAcxsAANgGAAA9EgAAoh0AAAcJAABsFAAA0R8AADYLAACbFgAAAAIAAGUNAADKGAAA
| LwQAAJQPAAD5GgAAXgYAAMMRAAAoHQAAjQgAAPITAACcCwAAARcAAGYCAADLDQAAMBkAAJUEAAD6DwAAXxsAAMQGAAApEgAA
| jh0AAPMIAABYFAAAvR8AACILAACHFgAA7AEAAFENAAC2GAAAGwQAAIAPAADlGgAASgYAAK8RAAAUHQAAeQgAAN4TAABDHwAA
| qAoAAA0WAAByAQAA1wwAADwYAAChAwAABg8AAGsaAADQBQAANREAAJocAAD/BwAAZBMAAMkeAAAuCgAAkxUAAPgAAABdDAAA
| whcAACcDAACMDgAA8RkAAFYFAAC7EAAAIBwAAIUHAADqEgAATx4AALQJAAAZFQAAfgAAAOMLAABIFwAArQIAABIOAAB3GQAA
| 3AQAAEEQAACmGwAACwcAAHASAADVHQAAOgkAAJ8UAAAEAAAAaQsAAM4WAAAzAgAAmA0AAP0YAABiBAAAxw8AACwbAACRBgAA
| 9hEAAFsdAADACAAAJRQAAIofAADvCgAAVBYAALkBAAAeDQAAgxgAAOgDAABNDwAAshoAABcGAAB8EQAA4RwAAEYIAACrEwAA
| EB8AAHUKAADaFQAAPwEAAKQMAAAJGAAAbgMAANMOAAA4GgAAnQUAAAIRAABnHAAAzAcAADETAACWHgAA+wkAAGAVAADFAAAA
| KgwAAI8XAAD0AgAAWQ4AAL4ZAAAjBQAAiBAAAO0bAABSBwAAtxIAABweAACBCQAA5hQAAEsAAACwCwAAFRcAAHoCAADfDQAA
| RBkAAKkEAAAOEAAAcxsAANgGAAA9EgAAoh0AAAcJAABsFAAA0R8AADYLAACbFgAAAAIAAGUNAADKGAAALwQAAJQPAAD5GgAA
| XgYAAMMRAAAoHQAAjQgAAPITAABXHwAAvAoAACEWAACGAQAA6wwAAFAYAAC1AwAAGg8AAH8aAADkBQAASREAAK4cAAATCAAA
| eBMAAN0eAABCCgAApxUAAAwBAABxDAAA1hcAADsDAACgDgAABRoAAGoFAADPEAAANBwAAJkHAAD+EgAAYx4AAMgJAAAtFQAA
| kgAAAPcLAABcFwAAwQIAACYOAACLGQAA8AQAAFUQAAC6GwAAHwcAAIQSAADpHQAATgkAALMUAAAYAAAAfQsAAOIWAABHAgAA
| rA0AABEZAAB2BAAA2w8AAEAbAAClBgAAChIAAG8dAADUCAAAORQAAJ4fAAADCwAAaBYAAM0BAAAyDQAAlxgAAPwDAABhDwAA
| xhoAACsGAACQEQAA9RwAAFoIAAC/EwAAJB8AAIkKAADuFQAAUwEAALgMAAAdGAAAggMAAOcOAABMGgAAsQUAABYRAAB7HAAA
| 4AcAAEUTAACqHgAADwoAAHQVAADZAAAAPgwAAKMXAAAIAwAAbQ4AANIZAAA3BQAA4RwAAEYIAACrEwAAEB8AAHUKAADaFQAA
| PwEAAKQMAAAJGAAAbgMAANMOAAA4GgAAnQUAAAIRAABnHAAAzAcAADETAACWHgAA+wkAAGAVAADFAAAAKgwAAI8XAAD0AgAA
| WQ4AAL4ZAAAjBQAAiBAAAO0bAABSBwAAtxIAABweAACBCQAA5hQAAEsAAACwCwAAFRcAAHoCAADfDQAARBkAAKkEAAAOEAAA
| cxsAANgGAAA9EgAAoh0AAAcJAABsFAAA0R8AADYLAACbFgAAAAIAAGUNAADKGAAALwQAAJQPAAD5GgAAXgYAAMMRAAAoHQAA
| jQgAAPITAABXHwAAvAoAACEWAACGAQAA6wwAAFAYAAC1AwAAGg8AAH8aAADkBQAASREAAK4cAAATCAAAeBMAAN0eAABCCgAA
| pxUAAAwBAABxDAAA1hcAADsDAACgDgAABRoAAGoFAADPEAAANBwAAJkHAAD+EgAAYx4AAMgJAAAtFQAAkgAAAPcLAABcFwAA
| wQIAACYOAACLGQAA8AQAAFUQAAC6GwAAHwcAAIQSAADpHQAATgkAALMUAAAYAAAAfQsAAOIWAABHAgAArA0AABEZAAB2BAAA
| 2w8AAEAbAAClBgAAChIAAG8dAADUCAAAORQAAJ4fAAADCwAAaBYAAM0BAAAyDQAAlxgAAPwDAABhDwAAxhoAACsGAACQEQAA
| 9RwAAFoIAAC/EwAAJB8AAIkKAADuFQAAUwEAALgMAAAdGAAAggMAAOcOAABMGgAAsQUAABYRAAB7HAAA4AcAAEUTAACqHgAA
| DwoAAHQVAADZAAAAPgwAAKMXAAAIAwAAbQ4AANIZAAA3BQAAnBAAAAEcAABmBwAAyxIAADAeAACVCQAA+hQAAF8AAADECwAA
| KRcAAI4CAADzDQAAWBkAAL0EAAAiEAAAhxsAAOwGAABREgAAth0AABsJAACAFAAA5R8AAEoLAACvFgAAFAIAAHkNAADeGAAA
| QwQAAKgPAAANGwAAcgYAANcRAAA8HQAAoQgAAAYUAABrHwAA0AoAADUWAACaAQAA/wwAAGQYAADJAwAALg8AAJMaAAD4BQAA
| XREAAMIcAAAnCAAAjBMAAPEeAABWCgAAuxUAACABAACFDAAA6hcAAE8DAAC0DgAAGRoAAH4FAADjEAAASBwAAK0HAAASEwAA
| dx4AANwJAABBFQAApgAAAAsMAABwFwAA1QIAADoOAACfGQAABAUAAGkQAADOGwAAMwcAAJgSAAD9HQAAYgkAAMcUAAAsAAAA
| kQsAAPYWAABbAgAAwA0AACUZAACKBAAA7w8AAFQbAAC5BgAAHhIAAIMdAADoCAAATRQAALIfAAAXCwAAfBYAACYOAACLGQAA
| 8AQAAFUQAAC6GwAAHwcAAIQSAADpHQAATgkAALMUAAAYAAAAfQsAAOIWAABHAgAArA0AABEZAAB2BAAA2w8AAEAbAAClBgAA
| ChIAAG8dAADUCAAAORQAAJ4fAAADCwAAaBYAAM0BAAAyDQAAlxgAAPwDAABhDwAAxhoAACsGAACQEQAA9RwAAFoIAAC/EwAA
| JB8AAIkKAADuFQAAUwEAALgMAAAdGAAAggMAAOcOAABMGgAAsQUAABYRAAB7HAAA4AcAAEUTAACqHgAADwoAAHQVAADZAAAA
| PgwAAKMXAAAIAwAAbQ4AANIZAAA3BQAAnBAAAAEcAABmBwAAyxIAADAeAACVCQAA+hQAAF8AAADECwAAKRcAAI4CAADzDQAA
| WBkAAL0EAAAiEAAAhxsAAOwGAABREgAAth0AABsJAACAFAAA5R8AAEoLAACvFgAAFAIAAHkNAADeGAAAQwQAAKgPAAANGwAA
| cgYAANcRAAA8HQAAoQgAAAYUAABrHwAA0AoAADUWAACaAQAA/wwAAGQYAADJAwAALg8AAJMaAAD4BQAAXREAAMIcAAAnCAAA
| jBMAAPEeAABWCgAAuxUAACABAACFDAAA6hcAAE8DAAC0DgAAGRoAAH4FAADjEAAASBwAAK0HAAASEwAAdx4AANwJAABBFQAA
| pgAAAAsMAABwFwAA1QIAADoOAACfGQAABAUAAGkQAADOGwAAMwcAAJgSAAD9HQAAYgkAAMcUAAAsAAAAkQsAAPYWAABbAgAA
| wA0AACUZAACKBAAA7w8AAFQbAAC5BgAAHhIAAIMdAADoCAAATRQAALIfAAAXCwAAfBYAAOEBAABGDQAAqxgAABAEAAB1DwAA
| 2hoAAD8GAACkEQAACR0AAG4IAADTEwAAOB8AAJ0KAAACFgAAZwEAAMwMAAAxGAAAlgMAAPsOAABgGgAAxQUAACoRAACPHAAA
| 9AcAAFkTAAC+HgAAIwoAAIgVAADtAAAAUgwAALcXAAAcAwAAgQ4AAOYZAABLBQAAsBAAABUcAAB6BwAA3xIAAEQeAACpCQAA
| DhUAAHMAAADYCwAAPRcAAKICAAAHDgAAbBkAANEEAAA2EAAAmxsAAAAHAABlEgAAyh0AAC8JAACUFAAA+R8AAF4LAADDFgAA
| KAIAAI0NAADyGAAAVwQAALwPAAAhGwAAhgYAAOsRAABQHQAAtQgAABoUAAB/HwAA5AoAAEkWAACuAQAAEw0AAHgYAADdAwAA
| Qg8AAKcaAAAMBgAAcREAANYcAAA7CAAAoBMAAAUfAABqCgAAzxUAADQBAACZDAAA/hcAAGMDAADIDgAALRoAAJIFAAD3EAAA
| XBwAAMEHAABrHwAA0AoAADUWAACaAQAA/wwAAGQYAADJAwAALg8AAJMaAAD4BQAAXREAAMIcAAAnCAAAjBMAAPEeAABWCgAA
| uxUAACABAACFDAAA6hcAAE8DAAC0DgAAGRoAAH4FAADjEAAASBwAAK0HAAASEwAAdx4AANwJAABBFQAApgAAAAsMAABwFwAA
| 1QIAADoOAACfGQAABAUAAGkQAADOGwAAMwcAAJgSAAD9HQAAYgkAAMcUAAAsAAAAkQsAAPYWAABbAgAAwA0AACUZAACKBAAA
| 7w8AAFQbAAC5BgAAHhIAAIMdAADoCAAATRQAALIfAAAXCwAAfBYAAOEBAABGDQAAqxgAABAEAAB1DwAA2hoAAD8GAACkEQAA
| CR0AAG4IAADTEwAAOB8AAJ0KAAACFgAAZwEAAMwMAAAxGAAAlgMAAPsOAABgGgAAxQUAACoRAACPHAAA9AcAAFkTAAC+HgAA
| IwoAAIgVAADtAAAAUgwAALcXAAAcAwAAgQ4AAOYZAABLBQAAsBAAABUcAAB6BwAA3xIAAEQeAACpCQAADhUAAHMAAADYCwAA
| PRcAAKICAAAHDgAAbBkAANEEAAA2EAAAmxsAAAAHAABlEgAAyh0AAC8JAACUFAAA+R8AAF4LAADDFgAAKAIAAI0NAADyGAAA
| VwQAALwPAAAhGwAAhgYAAOsRAABQHQAAtQgAABoUAAB/HwAA5AoAAEkWAACuAQAAEw0AAHgYAADdAwAAQg8AAKcaAAAMBgAA
| cREAANYcAAA7CAAAoBMAAAUfAABqCgAAzxUAADQBAACZDAAA/hcAAGMDAADIDgAALRoAAJIFAAD3EAAAXBwAAMEHAAAmEwAA
| ix4AAPAJAABVFQAAugAAAB8MAACEFwAA6QIAAE4OAACzGQAAGAUAAH0QAADiGwAARwcAAKwSAAARHgAAdgkAANsUAABAAAAA
| pQsAAAoXAABvAgAA1A0AADkZAACeBAAAAxAAAGgbAADNBgAAMhIAAJcdAAD8CAAAYRQAAMYfAAArCwAAkBYAAPUBAABaDQAA
| vxgAACQEAACJDwAA7hoAAFMGAAC4EQAAHR0AAIIIAADnEwAATB8AALEKAAAWFgAAewEAAOAMAABFGAAAqgMAAA8PAAB0GgAA
| 2QUAAD4RAACjHAAACAgAAG0TAADSHgAANwoAAJwVAAABAQAAZgwAAMsXAAAwAwAAlQ4AAPoZAABfBQAAxBAAACkcAACOBwAA
| 8xIAAFgeAAC9CQAAIhUAAIcAAADsCwAAURcAALYCAAAbDgAAgBkAAOUEAABKEAAArxsAABQHAAB5EgAA3h0AAEMJAACoFAAA
| DQAAAHILAADXFgAAPAIAAKENAAAGGQAAsBAAABUcAAB6BwAA3xIAAEQeAACpCQAADhUAAHMAAADYCwAAPRcAAKICAAAHDgAA
| bBkAANEEAAA2EAAAmxsAAAAHAABlEgAAyh0AAC8JAACUFAAA+R8AAF4LAADDFgAAKAIAAI0NAADyGAAAVwQAALwPAAAhGwAA
| hgYAAOsRAABQHQAAtQgAABoUAAB/HwAA5AoAAEkWAACuAQAAEw0AAHgYAADdAwAAQg8AAKcaAAAMBgAAcREAANYcAAA7CAAA
| oBMAAAUfAABqCgAAzxUAADQBAACZDAAA/hcAAGMDAADIDgAALRoAAJIFAAD3EAAAXBwAAMEHAAAmEwAAix4AAPAJAABVFQAA
| ugAAAB8MAACEFwAA6QIAAE4OAACzGQAAGAUAAH0QAADiGwAARwcAAKwSAAARHgAAdgkAANsUAABAAAAApQsAAAoXAABvAgAA
| 1A0AADkZAACeBAAAAxAAAGgbAADNBgAAMhIAAJcdAAD8CAAAYRQAAMYfAAArCwAAkBYAAPUBAABaDQAAvxgAACQEAACJDwAA
| 7hoAAFMGAAC4EQAAHR0AAIIIAADnEwAATB8AALEKAAAWFgAAewEAAOAMAABFGAAAqgMAAA8PAAB0GgAA2QUAAD4RAACjHAAA
| CAgAAG0TAADSHgAANwoAAJwVAAABAQAAZgwAAMsXAAAwAwAAlQ4AAPoZAABfBQAAxBAAACkcAACOBwAA8xIAAFgeAAC9CQAA
| IhUAAIcAAADsCwAAURcAALYCAAAbDgAAgBkAAOUEAABKEAAArxsAABQHAAB5EgAA3h0AAEMJAACoFAAADQAAAHILAADXFgAA
| PAIAAKENAAAGGQAAawQAANAPAAA1GwAAmgYAAP8RAABkHQAAyQgAAC4UAACTHwAA+AoAAF0WAADCAQAAJw0AAIwYAADxAwAA
| Vg8AALsaAAAgBgAAhREAAOocAABPCAAAtBMAABkfAAB+CgAA4xUAAEgBAACtDAAAEhgAAHcDAADcDgAAQRoAAKYFAAALEQAA
| cBwAANUHAAA6EwAAnx4AAAQKAABpFQAAzgAAADMMAACYFwAA/QIAAGIOAADHGQAALAUAAJEQAAD2GwAAWwcAAMASAAAlHgAA
| igkAAO8UAABUAAAAuQsAAB4XAACDAgAA6A0AAE0ZAACyBAAAFxAAAHwbAADhBgAARhIAAKsdAAAQCQAAdRQAANofAAA/CwAA
| pBYAAAkCAABuDQAA0xgAADgEAACdDwAAAhsAAGcGAADMEQAAMR0AAJYIAAD7EwAAYB8AAMUKAAAqFgAAjwEAAPQMAABZGAAA
| vgMAACMPAACIGgAA7QUAAFIRAAC3HAAAHAgAAIETAADmHgAASwoAAPUBAABaDQAAvxgAACQEAACJDwAA7hoAAFMGAAC4EQAA
| HR0AAIIIAADnEwAATB8AALEKAAAWFgAAewEAAOAMAABFGAAAqgMAAA8PAAB0GgAA2QUAAD4RAACjHAAACAgAAG0TAADSHgAA
| NwoAAJwVAAABAQAAZgwAAMsXAAAwAwAAlQ4AAPoZAABfBQAAxBAAACkcAACOBwAA8xIAAFgeAAC9CQAAIhUAAIcAAADsCwAA
| URcAALYCAAAbDgAAgBkAAOUEAABKEAAArxsAABQHAAB5EgAA3h0AAEMJAACoFAAADQAAAHILAADXFgAAPAIAAKENAAAGGQAA
| awQAANAPAAA1GwAAmgYAAP8RAABkHQAAyQgAAC4UAACTHwAA+AoAAF0WAADCAQAAJw0AAIwYAADxAwAAVg8AALsaAAAgBgAA
| hREAAOocAABPCAAAtBMAABkfAAB+CgAA4xUAAEgBAACtDAAAEhgAAHcDAADcDgAAQRoAAKYFAAALEQAAcBwAANUHAAA6EwAA
| nx4AAAQKAABpFQAAzgAAADMMAACYFwAA/QIAAGIOAADHGQAALAUAAJEQAAD2GwAAWwcAAMASAAAlHgAAigkAAO8UAABUAAAA
| uQsAAB4XAACDAgAA6A0AAE0ZAACyBAAAFxAAAHwbAADhBgAARhIAAKsdAAAQCQAAdRQAANofAAA/CwAApBYAAAkCAABuDQAA
| 0xgAADgEAACdDwAAAhsAAGcGAADMEQAAMR0AAJYIAAD7EwAAYB8AAMUKAAAqFgAAjwEAAPQMAABZGAAAvgMAACMPAACIGgAA
| 7QUAAFIRAAC3HAAAHAgAAIETAADmHgAASwoAALAVAAAVAQAAegwAAN8XAABEAwAAqQ4AAA4aAABzBQAA2BAAAD0cAACiBwAA
| BxMAAGweAADRCQAANhUAAJsAAAAADAAAZRcAAMoCAAAvDgAAlBkAAPkEAABeEAAAwxsAACgHAACNEgAA8h0AAFcJAAC8FAAA
| IQAAAIYLAADrFgAAUAIAALUNAAAaGQAAfwQAAOQPAABJGwAArgYAABMSAAB4HQAA3QgAAEIUAACnHwAADAsAAHEWAADWAQAA
| Ow0AAKAYAAAFBAAAag8AAM8aAAA0BgAAmREAAP4cAABjCAAAyBMAAC0fAACSCgAA9xUAAFwBAADBDAAAJhgAAIsDAADwDgAA
| VRoAALoFAAAfEQAAhBwAAOkHAABOEwAAsx4AABgKAAB9FQAA4gAAAEcMAACsFwAAEQMAAHYOAADbGQAAQAUAAKUQAAAKHAAA
| bwcAANQSAAA5HgAAngkAAAMVAABoAAAAzQsAADIXAACXAgAA/A0AAGEZAADGBAAAKxAAAJAbAAA6EwAAnx4AAAQKAABpFQAA
| zgAAADMMAACYFwAA/QIAAGIOAADHGQAALAUAAJEQAAD2GwAAWwcAAMASAAAlHgAAigkAAO8UAABUAAAAuQsAAB4XAACDAgAA
| 6A0AAE0ZAACyBAAAFxAAAHwbAADhBgAARhIAAKsdAAAQCQAAdRQAANofAAA/CwAApBYAAAkCAABuDQAA0xgAADgEAACdDwAA
| AhsAAGcGAADMEQAAMR0AAJYIAAD7EwAAYB8AAMUKAAAqFgAAjwEAAPQMAABZGAAAvgMAACMPAACIGgAA7QUAAFIRAAC3HAAA
| HAgAAIETAADmHgAASwoAALAVAAAVAQAAegwAAN8XAABEAwAAqQ4AAA4aAABzBQAA2BAAAD0cAACiBwAABxMAAGweAADRCQAA
| NhUAAJsAAAAADAAAZRcAAMoCAAAvDgAAlBkAAPkEAABeEAAAwxsAACgHAACNEgAA8h0AAFcJAAC8FAAAIQAAAIYLAADrFgAA
| UAIAALUNAAAaGQAAfwQAAOQPAABJGwAArgYAABMSAAB4HQAA3QgAAEIUAACnHwAADAsAAHEWAADWAQAAOw0AAKAYAAAFBAAA
| ag8AAM8aAAA0BgAAmREAAP4cAABjCAAAyBMAAC0fAACSCgAA9xUAAFwBAADBDAAAJhgAAIsDAADwDgAAVRoAALoFAAAfEQAA
| hBwAAOkHAABOEwAAsx4AABgKAAB9FQAA4gAAAEcMAACsFwAAEQMAAHYOAADbGQAAQAUAAKUQAAAKHAAAbwcAANQSAAA5HgAA
| ngkAAAMVAABoAAAAzQsAADIXAACXAgAA/A0AAGEZAADGBAAAKxAAAJAbAAD1BgAAWhIAAL8dAAAkCQAAiRQAAO4fAABTCwAA
| uBYAAB0CAACCDQAA5xgAAEwEAACxDwAAFhsAAHsGAADgEQAARR0AAKoIAAAPFAAAdB8AANkKAAA+FgAAowEAAAgNAABtGAAA
| 0gMAADcPAACcGgAAAQYAAGYRAADLHAAAMAgAAJUTAAD6HgAAXwoAAMQVAAApAQAAjgwAAPMXAABYAwAAvQ4AACIaAACHBQAA
| 7BAAAFEcAAC2BwAAGxMAAIAeAADlCQAAShUAAK8AAAAUDAAAeRcAAN4CAABDDgAAqBkAAA0FAAByEAAA1xsAADwHAAChEgAA
| Bh4AAGsJAADQFAAANQAAAJoLAAD/FgAAZAIAAMkNAAAuGQAAkwQAAPgPAABdGwAAwgYAACcSAACMHQAA8QgAAFYUAAC7HwAA
| IAsAAIUWAADqAQAATw0AALQYAAAZBAAAfg8AAOMaAABIBgAArREAABIdAAB3CAAA3BMAAEEfAACmCgAACxYAAHABAADVDAAA
| fwQAAOQPAABJGwAArgYAABMSAAB4HQAA3QgAAEIUAACnHwAADAsAAHEWAADWAQAAOw0AAKAYAAAFBAAAag8AAM8aAAA0BgAA
| mREAAP4cAABjCAAAyBMAAC0fAACSCgAA9xUAAFwBAADBDAAAJhgAAIsDAADwDgAAVRoAALoFAAAfEQAAhBwAAOkHAABOEwAA
| sx4AABgKAAB9FQAA4gAAAEcMAACsFwAAEQMAAHYOAADbGQAAQAUAAKUQAAAKHAAAbwcAANQSAAA5HgAAngkAAAMVAABoAAAA
| zQsAADIXAACXAgAA/A0AAGEZAADGBAAAKxAAAJAbAAD1BgAAWhIAAL8dAAAkCQAAiRQAAO4fAABTCwAAuBYAAB0CAACCDQAA
| 5xgAAEwEAACxDwAAFhsAAHsGAADgEQAARR0AAKoIAAAPFAAAdB8AANkKAAA+FgAAowEAAAgNAABtGAAA0gMAADcPAACcGgAA
| AQYAAGYRAADLHAAAMAgAAJUTAAD6HgAAXwoAAMQVAAApAQAAjgwAAPMXAABYAwAAvQ4AACIaAACHBQAA7BAAAFEcAAC2BwAA
| GxMAAIAeAADlCQAAShUAAK8AAAAUDAAAeRcAAN4CAABDDgAAqBkAAA0FAAByEAAA1xsAADwHAAChEgAABh4AAGsJAADQFAAA
| NQAAAJoLAAD/FgAAZAIAAMkNAAAuGQAAkwQAAPgPAABdGwAAwgYAACcSAACMHQAA8QgAAFYUAAC7HwAAIAsAAIUWAADqAQAA
| Tw0AALQYAAAZBAAAfg8AAOMaAABIBgAArREAABIdAAB3CAAA3BMAAEEfAACmCgAACxYAAHABAADVDAAAOhgAAJ8DAAAEDwAA
| aRoAAM4FAAAzEQAAmBwAAP0HAABiEwAAxx4AACwKAACRFQAA9gAAAFsMAADAFwAAJQMAAIoOAADvGQAAVAUAALkQAAAeHAAA
| gwcAAOgSAABNHgAAsgkAABcVAAB8AAAA4QsAAEYXAACrAgAAEA4AAHUZAADaBAAAPxAAAKQbAAAJBwAAbhIAANMdAAA4CQAA
| nRQAAAIAAABnCwAAzBYAADECAACWDQAA+xgAAGAEAADFDwAAKhsAAI8GAAD0EQAAWR0AAL4IAAAjFAAAiB8AAO0KAABSFgAA
| twEAABwNAACBGAAA5gMAAEsPAACwGgAAFQYAAHoRAADfHAAARAgAAKkTAAAOHwAAcwoAANgVAAA9AQAAogwAAAcYAABsAwAA
| 0Q4AADYaAACbBQAAABEAAGUcAADKBwAALxMAAJQeAAD5CQAAXhUAAMMAAAAoDAAAjRcAAPICAABXDgAAvBkAACEFAACGEAAA
| 6xsAAFAHAAC1EgAAGh4AAMQVAAApAQAAjgwAAPMXAABYAwAAvQ4AACIaAACHBQAA7BAAAFEcAAC2BwAAGxMAAIAeAADlCQAA
| ShUAAK8AAAAUDAAAeRcAAN4CAABDDgAAqBkAAA0FAAByEAAA1xsAADwHAAChEgAABh4AAGsJAADQFAAANQAAAJoLAAD/FgAA
| ZAIAAMkNAAAuGQAAkwQAAPgPAABdGwAAwgYAACcSAACMHQAA8QgAAFYUAAC7HwAAIAsAAIUWAADqAQAATw0AALQYAAAZBAAA
| fg8AAOMaAABIBgAArREAABIdAAB3CAAA3BMAAEEfAACmCgAACxYAAHABAADVDAAAOhgAAJ8DAAAEDwAAaRoAAM4FAAAzEQAA
| mBwAAP0HAABiEwAAxx4AACwKAACRFQAA9gAAAFsMAADAFwAAJQMAAIoOAADvGQAAVAUAALkQAAAeHAAAgwcAAOgSAABNHgAA
| sgkAABcVAAB8AAAA4QsAAEYXAACrAgAAEA4AAHUZAADaBAAAPxAAAKQbAAAJBwAAbhIAANMdAAA4CQAAnRQAAAIAAABnCwAA
| zBYAADECAACWDQAA+xgAAGAEAADFDwAAKhsAAI8GAAD0EQAAWR0AAL4IAAAjFAAAiB8AAO0KAABSFgAAtwEAABwNAACBGAAA
| 5gMAAEsPAACwGgAAFQYAAHoRAADfHAAARAgAAKkTAAAOHwAAcwoAANgVAAA9AQAAogwAAAcYAABsAwAA0Q4AADYaAACbBQAA
| ABEAAGUcAADKBwAALxMAAJQeAAD5CQAAXhUAAMMAAAAoDAAAjRcAAPICAABXDgAAvBkAACEFAACGEAAA6xsAAFAHAAC1EgAA
| Gh4AAH8JAADkFAAASQAAAK4LAAATFwAAeAIAAN0NAABCGQAApwQAAAwQAABxGwAA1gYAADsSAACgHQAABQkAAGoUAADPHwAA
| NAsAAJkWAAD+AQAAYw0AAMgYAAAtBAAAkg8AAPcaAABcBgAAwREAACYdAACLCAAA8BMAAFUfAAC6CgAAHxYAAIQBAADpDAAA
| ThgAALMDAAAYDwAAfRoAAOIFAABHEQAArBwAABEIAAB2EwAA2x4AAEAKAAClFQAACgEAAG8MAADUFwAAOQMAAJ4OAAADGgAA
| aAUAAM0QAAAyHAAAlwcAAPwSAABhHgAAxgkAACsVAACQAAAA9QsAAFoXAAC/AgAAJA4AAIkZAADuBAAAUxAAALgbAAAdBwAA
| ghIAAOcdAABMCQAAsRQAABYAAAB7CwAA4BYAAEUCAACqDQAADxkAAHQEAADZDwAAPhsAAKMGAAAIEgAAbR0AANIIAAA3FAAA
| nB8AAAELAABmFgAAywEAADANAACVGAAA+gMAAF8PAAAJBwAAbhIAANMdAAA4CQAAnRQAAAIAAABnCwAAzBYAADECAACWDQAA
| +xgAAGAEAADFDwAAKhsAAI8GAAD0EQAAWR0AAL4IAAAjFAAAiB8AAO0KAABSFgAAtwEAABwNAACBGAAA5gMAAEsPAACwGgAA
| FQYAAHoRAADfHAAARAgAAKkTAAAOHwAAcwoAANgVAAA9AQAAogwAAAcYAABsAwAA0Q4AADYaAACbBQAAABEAAGUcAADKBwAA
| LxMAAJQeAAD5CQAAXhUAAMMAAAAoDAAAjRcAAPICAABXDgAAvBkAACEFAACGEAAA6xsAAFAHAAC1EgAAGh4AAH8JAADkFAAA
| SQAAAK4LAAATFwAAeAIAAN0NAABCGQAApwQAAAwQAABxGwAA1gYAADsSAACgHQAABQkAAGoUAADPHwAANAsAAJkWAAD+AQAA
| Yw0AAMgYAAAtBAAAkg8AAPcaAABcBgAAwREAACYdAACLCAAA8BMAAFUfAAC6CgAAHxYAAIQBAADpDAAAThgAALMDAAAYDwAA
| fRoAAOIFAABHEQAArBwAABEIAAB2EwAA2x4AAEAKAAClFQAACgEAAG8MAADUFwAAOQMAAJ4OAAADGgAAaAUAAM0QAAAyHAAA
| lwcAAPwSAABhHgAAxgkAACsVAACQAAAA9QsAAFoXAAC/AgAAJA4AAIkZAADuBAAAUxAAALgbAAAdBwAAghIAAOcdAABMCQAA
| sRQAABYAAAB7CwAA4BYAAEUCAACqDQAADxkAAHQEAADZDwAAPhsAAKMGAAAIEgAAbR0AANIIAAA3FAAAnB8AAAELAABmFgAA
| ywEAADANAACVGAAA+gMAAF8PAADEGgAAKQYAAI4RAADzHAAAWAgAAL0TAAAiHwAAhwoAAOwVAABRAQAAtgwAABsYAACAAwAA
| 5Q4AAEoaAACvBQAAFBEAAHkcAADeBwAAQxMAAKgeAAANCgAAchUAANcAAAA8DAAAoRcAAAYDAABrDgAA0BkAADUFAACaEAAA
| /xsAAGQHAADJEgAALh4AAJMJAAD4FAAAXQAAAMILAAAnFwAAjAIAAPENAABWGQAAuwQAACAQAACFGwAA6gYAAE8SAAC0HQAA
| GQkAAH4UAADjHwAASAsAAK0WAAASAgAAdw0AANwYAABBBAAApg8AAAsbAABwBgAA1REAADodAACfCAAABBQAAGkfAADOCgAA
| MxYAAJgBAAD9DAAAYhgAAMcDAAAsDwAAkRoAAPYFAABbEQAAwBwAACUIAACKEwAA7x4AAFQKAAC5FQAAHgEAAIMMAADoFwAA
| TQMAALIOAAAXGgAAfAUAAOEQAABGHAAAqwcAABATAAB1HgAA2gkAAD8VAACkAAAAThgAALMDAAAYDwAAfRoAAOIFAABHEQAA
| rBwAABEIAAB2EwAA2x4AAEAKAAClFQAACgEAAG8MAADUFwAAOQMAAJ4OAAADGgAAaAUAAM0QAAAyHAAAlwcAAPwSAABhHgAA
| xgkAACsVAACQAAAA9QsAAFoXAAC/AgAAJA4AAIkZAADuBAAAUxAAALgbAAAdBwAAghIAAOcdAABMCQAAsRQAABYAAAB7CwAA
| 4BYAAEUCAACqDQAADxkAAHQEAADZDwAAPhsAAKMGAAAIEgAAbR0AANIIAAA3FAAAnB8AAAELAABmFgAAywEAADANAACVGAAA
| +gMAAF8PAADEGgAAKQYAAI4RAADzHAAAWAgAAL0TAAAiHwAAhwoAAOwVAABRAQAAtgwAABsYAACAAwAA5Q4AAEoaAACvBQAA
| FBEAAHkcAADeBwAAQxMAAKgeAAANCgAAchUAANcAAAA8DAAAoRcAAAYDAABrDgAA0BkAADUFAACaEAAA/xsAAGQHAADJEgAA
| Lh4AAJMJAAD4FAAAXQAAAMILAAAnFwAAjAIAAPENAABWGQAAuwQAACAQAACFGwAA6gYAAE8SAAC0HQAAGQkAAH4UAADjHwAA
| SAsAAK0WAAASAgAAdw0AANwYAABBBAAApg8AAAsbAABwBgAA1REAADodAACfCAAABBQAAGkfAADOCgAAMxYAAJgBAAD9DAAA
| YhgAAMcDAAAsDwAAkRoAAPYFAABbEQAAwBwAACUIAACKEwAA7x4AAFQKAAC5FQAAHgEAAIMMAADoFwAATQMAALIOAAAXGgAA
| fAUAAOEQAABGHAAAqwcAABATAAB1HgAA2gkAAD8VAACkAAAACQwAAG4XAADTAgAAOA4AAJ0ZAAACBQAAZxAAAMwbAAAxBwAA
| lhIAAPsdAABgCQAAxRQAACoAAACPCwAA9BYAAFkCAAC+DQAAIxkAAIgEAADtDwAAUhsAALcGAAAcEgAAgR0AAOYIAABLFAAA
| sB8AABULAAB6FgAA3wEAAEQNAACpGAAADgQAAHMPAADYGgAAPQYAAKIRAAAHHQAAbAgAANETAAA2HwAAmwoAAAAWAABlAQAA
| ygwAAC8YAACUAwAA+Q4AAF4aAADDBQAAKBEAAI0cAADyBwAAVxMAALweAAAhCgAAhhUAAOsAAABQDAAAtRcAABoDAAB/DgAA
| 5BkAAEkFAACuEAAAExwAAHgHAADdEgAAQh4AAKcJAAAMFQAAcQAAANYLAAA7FwAAoAIAAAUOAABqGQAAzwQAADQQAACZGwAA
| /gYAAGMSAADIHQAALQkAAJIUAAD3HwAAXAsAAMEWAAAmAgAAiw0AAPAYAABVBAAAug8AAB8bAACEBgAA6REAAJMJAAD4FAAA
| XQAAAMILAAAnFwAAjAIAAPENAABWGQAAuwQAACAQAACFGwAA6gYAAE8SAAC0HQAAGQkAAH4UAADjHwAASAsAAK0WAAASAgAA
| dw0AANwYAABBBAAApg8AAAsbAABwBgAA1REAADodAACfCAAABBQAAGkfAADOCgAAMxYAAJgBAAD9DAAAYhgAAMcDAAAsDwAA
| kRoAAPYFAABbEQAAwBwAACUIAACKEwAA7x4AAFQKAAC5FQAAHgEAAIMMAADoFwAATQMAALIOAAAXGgAAfAUAAOEQAABGHAAA
| qwcAABATAAB1HgAA2gkAAD8VAACkAAAACQwAAG4XAADTAgAAOA4AAJ0ZAAACBQAAZxAAAMwbAAAxBwAAlhIAAPsdAABgCQAA
| xRQAACoAAACPCwAA9BYAAFkCAAC+DQAAIxkAAIgEAADtDwAAUhsAALcGAAAcEgAAgR0AAOYIAABLFAAAsB8AABULAAB6FgAA
| 3wEAAEQNAACpGAAADgQAAHMPAADYGgAAPQYAAKIRAAAHHQAAbAgAANETAAA2HwAAmwoAAAAWAABlAQAAygwAAC8YAACUAwAA
| +Q4AAF4aAADDBQAAKBEAAI0cAADyBwAAVxMAALweAAAhCgAAhhUAAOsAAABQDAAAtRcAABoDAAB/DgAA5BkAAEkFAACuEAAA
| ExwAAHgHAADdEgAAQh4AAKcJAAAMFQAAcQAAANYLAAA7FwAAoAIAAAUOAABqGQAAzwQAADQQAACZGwAA/gYAAGMSAADIHQAA
| LQkAAJIUAAD3HwAAXAsAAMEWAAAmAgAAiw0AAPAYAABVBAAAug8AAB8bAACEBgAA6REAAE4dAACzCAAAGBQAAH0fAADiCgAA
| RxYAAKwBAAARDQAAdhgAANsDAABADwAApRoAAAoGAABvEQAA1BwAADkIAACeEwAAAx8AAGgKAADNFQAAMgEAAJcMAAD8FwAA
| YQMAAMYOAAArGgAAkAUAAPUQAABaHAAAvwcAACQTAACJHgAA7gkAAFMVAAC4AAAAHQwAAIIXAADnAgAATA4AALEZAAAWBQAA
| exAAAOAbAABFBwAAqhIAAA8eAAB0CQAA2RQAAD4AAACjCwAACBcAAG0CAADSDQAANxkAAJwEAAABEAAAZhsAAMsGAAAwEgAA
| lR0AAPoIAABfFAAAxB8AACkLAACOFgAA8wEAAFgNAAC9GAAAIgQAAIcPAADsGgAAUQYAALYRAAAbHQAAgAgAAOUTAABKHwAA
| rwoAABQWAAB5AQAA3gwAAEMYAACoAwAADQ8AAHIaAADXBQAAPBEAAKEcAAAGCAAAaxMAANAeAAA1CgAAmhUAAP8AAABkDAAA
| yRcAAC4DAADYGgAAPQYAAKIRAAAHHQAAbAgAANETAAA2HwAAmwoAAAAWAABlAQAAygwAAC8YAACUAwAA+Q4AAF4aAADDBQAA
| KBEAAI0cAADyBwAAVxMAALweAAAhCgAAhhUAAOsAAABQDAAAtRcAABoDAAB/DgAA5BkAAEkFAACuEAAAExwAAHgHAADdEgAA
| Qh4AAKcJAAAMFQAAcQAAANYLAAA7FwAAoAIAAAUOAABqGQAAzwQAADQQAACZGwAA/gYAAGMSAADIHQAALQkAAJIUAAD3HwAA
| XAsAAMEWAAAmAgAAiw0AAPAYAABVBAAAug8AAB8bAACEBgAA6REAAE4dAACzCAAAGBQAAH0fAADiCgAARxYAAKwBAAARDQAA
| dhgAANsDAABADwAApRoAAAoGAABvEQAA1BwAADkIAACeEwAAAx8AAGgKAADNFQAAMgEAAJcMAAD8FwAAYQMAAMYOAAArGgAA
| kAUAAPUQAABaHAAAvwcAACQTAACJHgAA7gkAAFMVAAC4AAAAHQwAAIIXAADnAgAATA4AALEZAAAWBQAAexAAAOAbAABFBwAA
| qhIAAA8eAAB0CQAA2RQAAD4AAACjCwAACBcAAG0CAADSDQAANxkAAJwEAAABEAAAZhsAAMsGAAAwEgAAlR0AAPoIAABfFAAA
| xB8AACkLAACOFgAA8wEAAFgNAAC9GAAAIgQAAIcPAADsGgAAUQYAALYRAAAbHQAAgAgAAOUTAABKHwAArwoAABQWAAB5AQAA
| 3gwAAEMYAACoAwAADQ8AAHIaAADXBQAAPBEAAKEcAAAGCAAAaxMAANAeAAA1CgAAmhUAAP8AAABkDAAAyRcAAC4DAACTDgAA
| +BkAAF0FAADCEAAAJxwAAIwHAADxEgAAVh4AALsJAAAgFQAAhQAAAOoLAABPFwAAtAIAABkOAAB+GQAA4wQAAEgQAACtGwAA
| EgcAAHcSAADcHQAAQQkAAKYUAAALAAAAcAsAANUWAAA6AgAAnw0AAAQZAABpBAAAzg8AADMbAACYBgAA/REAAGIdAADHCAAA
| LBQAAJEfAAD2CgAAWxYAAMABAAAlDQAAihgAAO8DAABUDwAAuRoAAB4GAACDEQAA6BwAAE0IAACyEwAAFx8AAHwKAADhFQAA
| RgEAAKsMAAAQGAAAdQMAANoOAAA/GgAApAUAAAkRAABuHAAA0wcAADgTAACdHgAAAgoAAGcVAADMAAAAMQwAAJYXAAD7AgAA
| YA4AAMUZAAAqBQAAjxAAAPQbAABZBwAAvhIAACMeAACICQAA7RQAAFIAAAC3CwAAHBcAAIECAADmDQAASxkAALAEAAAVEAAA
| ehsAAN8GAABEEgAAqR0AAA4JAABzFAAAHQwAAIIXAADnAgAATA4AALEZAAAWBQAAexAAAOAbAABFBwAAqhIAAA8eAAB0CQAA
| 2RQAAD4AAACjCwAACBcAAG0CAADSDQAANxkAAJwEAAABEAAAZhsAAMsGAAAwEgAAlR0AAPoIAABfFAAAxB8AACkLAACOFgAA
| 8wEAAFgNAAC9GAAAIgQAAIcPAADsGgAAUQYAALYRAAAbHQAAgAgAAOUTAABKHwAArwoAABQWAAB5AQAA3gwAAEMYAACoAwAA
| DQ8AAHIaAADXBQAAPBEAAKEcAAAGCAAAaxMAANAeAAA1CgAAmhUAAP8AAABkDAAAyRcAAC4DAACTDgAA+BkAAF0FAADCEAAA
| JxwAAIwHAADxEgAAVh4AALsJAAAgFQAAhQAAAOoLAABPFwAAtAIAABkOAAB+GQAA4wQAAEgQAACtGwAAEgcAAHcSAADcHQAA
| QQkAAKYUAAALAAAAcAsAANUWAAA6AgAAnw0AAAQZAABpBAAAzg8AADMbAACYBgAA/REAAGIdAADHCAAALBQAAJEfAAD2CgAA
| WxYAAMABAAAlDQAAihgAAO8DAABUDwAAuRoAAB4GAACDEQAA6BwAAE0IAACyEwAAFx8AAHwKAADhFQAARgEAAKsMAAAQGAAA
| dQMAANoOAAA/GgAApAUAAAkRAABuHAAA0wcAADgTAACdHgAAAgoAAGcVAADMAAAAMQwAAJYXAAD7AgAAYA4AAMUZAAAqBQAA
| jxAAAPQbAABZBwAAvhIAACMeAACICQAA7RQAAFIAAAC3CwAAHBcAAIECAADmDQAASxkAALAEAAAVEAAAehsAAN8GAABEEgAA
| qR0AAA4JAABzFAAA2B8AAD0LAACiFgAABwIAAGwNAADRGAAANgQAAJsPAAAAGwAAZQYAAMoRAAAvHQAAlAgAAPkTAABeHwAA
| wwoAACgWAACNAQAA8gwAAFcYAAC8AwAAIQ8AAIYaAADrBQAAUBEAALUcAAAaCAAAfxMAAOQeAABJCgAArhUAABMBAAB4DAAA
| 3RcAAEIDAACnDgAADBoAAHEFAADWEAAAOxwAAKAHAAAFEwAAah4AAM8JAAA0FQAAmQAAAP4LAABjFwAAyAIAAC0OAACSGQAA
| 9wQAAFwQAADBGwAAJgcAAIsSAADwHQAAVQkAALoUAAAfAAAAhAsAAOkWAABOAgAAsw0AABgZAAB9BAAA4g8AAEcbAACsBgAA
| ERIAAHYdAADbCAAAQBQAAKUfAAAKCwAAbxYAANQBAAA5DQAAnhgAAAMEAABoDwAAzRoAADIGAACXEQAA/BwAAGEIAADGEwAA
| Kx8AAJAKAAD1FQAAWgEAAL8MAAAkGAAAiQMAAO4OAABTGgAAuAUAAGIdAADHCAAALBQAAJEfAAD2CgAAWxYAAMABAAAlDQAA
| ihgAAO8DAABUDwAAuRoAAB4GAACDEQAA6BwAAE0IAACyEwAAFx8AAHwKAADhFQAARgEAAKsMAAAQGAAAdQMAANoOAAA/GgAA
| pAUAAAkRAABuHAAA0wcAADgTAACdHgAAAgoAAGcVAADMAAAAMQwAAJYXAAD7AgAAYA4AAMUZAAAqBQAAjxAAAPQbAABZBwAA
| vhIAACMeAACICQAA7RQAAFIAAAC3CwAAHBcAAIECAADmDQAASxkAALAEAAAVEAAAehsAAN8GAABEEgAAqR0AAA4JAABzFAAA
| 2B8AAD0LAACiFgAABwIAAGwNAADRGAAANgQAAJsPAAAAGwAAZQYAAMoRAAAvHQAAlAgAAPkTAABeHwAAwwoAACgWAACNAQAA
| 8gwAAFcYAAC8AwAAIQ8AAIYaAADrBQAAUBEAALUcAAAaCAAAfxMAAOQeAABJCgAArhUAABMBAAB4DAAA3RcAAEIDAACnDgAA
| DBoAAHEFAADWEAAAOxwAAKAHAAAFEwAAah4AAM8JAAA0FQAAmQAAAP4LAABjFwAAyAIAAC0OAACSGQAA9wQAAFwQAADBGwAA
| JgcAAIsSAADwHQAAVQkAALoUAAAfAAAAhAsAAOkWAABOAgAAsw0AABgZAAB9BAAA4g8AAEcbAACsBgAAERIAAHYdAADbCAAA
| QBQAAKUfAAAKCwAAbxYAANQBAAA5DQAAnhgAAAMEAABoDwAAzRoAADIGAACXEQAA/BwAAGEIAADGEwAAKx8AAJAKAAD1FQAA
| WgEAAL8MAAAkGAAAiQMAAO4OAABTGgAAuAUAAB0RAACCHAAA5wcAAEwTAACxHgAAFgoAAHsVAADgAAAARQwAAKoXAAAPAwAA
| dA4AANkZAAA+BQAAoxAAAAgcAABtBwAA0hIAADceAACcCQAAARUAAGYAAADLCwAAMBcAAJUCAAD6DQAAXxkAAMQEAAApEAAA
| jhsAAPMGAABYEgAAvR0AACIJAACHFAAA7B8AAFELAAC2FgAAGwIAAIANAADlGAAASgQAAK8PAAAUGwAAeQYAAN4RAABDHQAA
| qAgAAA0UAAByHwAA1woAADwWAAChAQAABg0AAGsYAADQAwAANQ8AAJoaAAD/BQAAZBEAAMkcAAAuCAAAkxMAAPgeAABdCgAA
| whUAACcBAACMDAAA8RcAAFYDAAC7DgAAIBoAAIUFAADqEAAATxwAALQHAAAZEwAAfh4AAOMJAABIFQAArQAAABIMAAB3FwAA
| 3AIAAEEOAACmGQAACwUAAHAQAADVGwAAOgcAAJ8SAAAEHgAAaQkAAM4UAAAzAAAAmAsAAP0WAACnDgAADBoAAHEFAADWEAAA
| OxwAAKAHAAAFEwAAah4AAM8JAAA0FQAAmQAAAP4LAABjFwAAyAIAAC0OAACSGQAA9wQAAFwQAADBGwAAJgcAAIsSAADwHQAA
| VQkAALoUAAAfAAAAhAsAAOkWAABOAgAAsw0AABgZAAB9BAAA4g8AAEcbAACsBgAAERIAAHYdAADbCAAAQBQAAKUfAAAKCwAA
| bxYAANQBAAA5DQAAnhgAAAMEAABoDwAAzRoAADIGAACXEQAA/BwAAGEIAADGEwAAKx8AAJAKAAD1FQAAWgEAAL8MAAAkGAAA
| iQMAAO4OAABTGgAAuAUAAB0RAACCHAAA5wcAAEwTAACxHgAAFgoAAHsVAADgAAAARQwAAKoXAAAPAwAAdA4AANkZAAA+BQAA
| oxAAAAgcAABtBwAA0hIAADceAACcCQAAARUAAGYAAADLCwAAMBcAAJUCAAD6DQAAXxkAAMQEAAApEAAAjhsAAPMGAABYEgAA
| vR0AACIJAACHFAAA7B8AAFELAAC2FgAAGwIAAIANAADlGAAASgQAAK8PAAAUGwAAeQYAAN4RAABDHQAAqAgAAA0UAAByHwAA
| 1woAADwWAAChAQAABg0AAGsYAADQAwAANQ8AAJoaAAD/BQAAZBEAAMkcAAAuCAAAkxMAAPgeAABdCgAAwhUAACcBAACMDAAA
| 8RcAAFYDAAC7DgAAIBoAAIUFAADqEAAATxwAALQHAAAZEwAAfh4AAOMJAABIFQAArQAAABIMAAB3FwAA3AIAAEEOAACmGQAA
| CwUAAHAQAADVGwAAOgcAAJ8SAAAEHgAAaQkAAM4UAAAzAAAAmAsAAP0WAABiAgAAxw0AACwZAACRBAAA9g8AAFsbAADABgAA
| JRIAAIodAADvCAAAVBQAALkfAAAeCwAAgxYAAOgBAABNDQAAshgAABcEAAB8DwAA4RoAAEYGAACrEQAAEB0AAHUIAADaEwAA
| Px8AAKQKAAAJFgAAbgEAANMMAAA4GAAAnQMAAAIPAABnGgAAzAUAADERAACWHAAA+wcAAGATAADFHgAAKgoAAI8VAAD0AAAA
| WQwAAL4XAAAjAwAAiA4AAO0ZAABSBQAAtxAAABwcAACBBwAA5hIAAEseAACwCQAAFRUAAHoAAADfCwAARBcAAKkCAAAODgAA
| cxkAANgEAAA9EAAAohsAAAcHAABsEgAA0R0AADYJAACbFAAAAAAAAGULAADKFgAALwIAAJQNAAD5GAAAXgQAAMMPAAAoGwAA
| jQYAAPIRAABXHQAAvAgAACEUAACGHwAA6woAAFAWAAC1AQAAGg0AAH8YAADkAwAASQ8AAK4aAAATBgAAeBEAAN0cAABCCAAA
| 7B8AAFELAAC2FgAAGwIAAIANAADlGAAASgQAAK8PAAAUGwAAeQYAAN4RAABDHQAAqAgAAA0UAAByHwAA1woAADwWAAChAQAA
| Bg0AAGsYAADQAwAANQ8AAJoaAAD/BQAAZBEAAMkcAAAuCAAAkxMAAPgeAABdCgAAwhUAACcBAACMDAAA8RcAAFYDAAC7DgAA
| IBoAAIUFAADqEAAATxwAALQHAAAZEwAAfh4AAOMJAABIFQAArQAAABIMAAB3FwAA3AIAAEEOAACmGQAACwUAAHAQAADVGwAA
| OgcAAJ8SAAAEHgAAaQkAAM4UAAAzAAAAmAsAAP0WAABiAgAAxw0AACwZAACRBAAA9g8AAFsbAADABgAAJRIAAIodAADvCAAA
| VBQAALkfAAAeCwAAgxYAAOgBAABNDQAAshgAABcEAAB8DwAA4RoAAEYGAACrEQAAEB0AAHUIAADaEwAAPx8AAKQKAAAJFgAA
| bgEAANMMAAA4GAAAnQMAAAIPAABnGgAAzAUAADERAACWHAAA+wcAAGATAADFHgAAKgoAAI8VAAD0AAAAWQwAAL4XAAAjAwAA
| iA4AAO0ZAABSBQAAtxAAABwcAACBBwAA5hIAAEseAACwCQAAFRUAAHoAAADfCwAARBcAAKkCAAAODgAAcxkAANgEAAA9EAAA
| ohsAAAcHAABsEgAA0R0AADYJAACbFAAAAAAAAGULAADKFgAALwIAAJQNAAD5GAAAXgQAAMMPAAAoGwAAjQYAAPIRAABXHQAA
| vAgAACEUAACGHwAA6woAAFAWAAC1AQAAGg0AAH8YAADkAwAASQ8AAK4aAAATBgAAeBEAAN0cAABCCAAApxMAAAwfAABxCgAA
| 1hUAADsBAACgDAAABRgAAGoDAADPDgAANBoAAJkFAAD+EAAAYxwAAMgHAAAtEwAAkh4AAPcJAABcFQAAwQAAACYMAACLFwAA
| 8AIAAFUOAAC6GQAAHwUAAIQQAADpGwAATgcAALMSAAAYHgAAfQkAAOIUAABHAAAArAsAABEXAAB2AgAA2w0AAEAZAAClBAAA
| ChAAAG8bAADUBgAAORIAAJ4dAAADCQAAaBQAAM0fAAAyCwAAlxYAAPwBAABhDQAAxhgAACsEAACQDwAA9RoAAFoGAAC/EQAA
| JB0AAIkIAADuEwAAUx8AALgKAAAdFgAAggEAAOcMAABMGAAAsQMAABYPAAB7GgAA4AUAAEURAACqHAAADwgAAHQTAADZHgAA
| PgoAAKMVAAAIAQAAbQwAANIXAAA3AwAAnA4AAAEaAABmBQAAyxAAADAcAACVBwAA+hIAAF8eAADECQAAKRUAAI4AAADzCwAA
| WBcAAL0CAAAiDgAAhxkAADERAACWHAAA+wcAAGATAADFHgAAKgoAAI8VAAD0AAAAWQwAAL4XAAAjAwAAiA4AAO0ZAABSBQAA
| txAAABwcAACBBwAA5hIAAEseAACwCQAAFRUAAHoAAADfCwAARBcAAKkCAAAODgAAcxkAANgEAAA9EAAAohsAAAcHAABsEgAA
| 0R0AADYJAACbFAAAAAAAAGULAADKFgAALwIAAJQNAAD5GAAAXgQAAMMPAAAoGwAAjQYAAPIRAABXHQAAvAgAACEUAACGHwAA
| 6woAAFAWAAC1AQAAGg0AAH8YAADkAwAASQ8AAK4aAAATBgAAeBEAAN0cAABCCAAApxMAAAwfAABxCgAA1hUAADsBAACgDAAA
| BRgAAGoDAADPDgAANBoAAJkFAAD+EAAAYxwAAMgHAAAtEwAAkh4AAPcJAABcFQAAwQAAACYMAACLFwAA8AIAAFUOAAC6GQAA
| HwUAAIQQAADpGwAATgcAALMSAAAYHgAAfQkAAOIUAABHAAAArAsAABEXAAB2AgAA2w0AAEAZAAClBAAAChAAAG8bAADUBgAA
| ORIAAJ4dAAADCQAAaBQAAM0fAAAyCwAAlxYAAPwBAABhDQAAxhgAACsEAACQDwAA9RoAAFoGAAC/EQAAJB0AAIkIAADuEwAA
| Ux8AALgKAAAdFgAAggEAAOcMAABMGAAAsQMAABYPAAB7GgAA4AUAAEURAACqHAAADwgAAHQTAADZHgAAPgoAAKMVAAAIAQAA
| bQwAANIXAAA3AwAAnA4AAAEaAABmBQAAyxAAADAcAACVBwAA+hIAAF8eAADECQAAKRUAAI4AAADzCwAAWBcAAL0CAAAiDgAA
| hxkAAOwEAABREAAAthsAABsHAACAEgAA5R0AAEoJAACvFAAAFAAAAHkLAADeFgAAQwIAAKgNAAANGQAAcgQAANcPAAA8GwAA
| oQYAAAYSAABrHQAA0AgAADUUAACaHwAA/woAAGQWAADJAQAALg0AAJMYAAD4AwAAXQ8AAMIaAAAnBgAAjBEAAPEcAABWCAAA
| uxMAACAfAACFCgAA6hUAAE8BAAC0DAAAGRgAAH4DAADjDgAASBoAAK0FAAASEQAAdxwAANwHAABBEwAAph4AAAsKAABwFQAA
| 1QAAADoMAACfFwAABAMAAGkOAADOGQAAMwUAAJgQAAD9GwAAYgcAAMcSAAAsHgAAkQkAAPYUAABbAAAAwAsAACUXAACKAgAA
| 7w0AAFQZAAC5BAAAHhAAAIMbAADoBgAATRIAALIdAAAXCQAAfBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAA
| CRsAAG4GAADTEQAAOB0AAJ0IAAACFAAAZx8AAMwKAAB2AgAA2w0AAEAZAAClBAAAChAAAG8bAADUBgAAORIAAJ4dAAADCQAA
| aBQAAM0fAAAyCwAAlxYAAPwBAABhDQAAxhgAACsEAACQDwAA9RoAAFoGAAC/EQAAJB0AAIkIAADuEwAAUx8AALgKAAAdFgAA
| ggEAAOcMAABMGAAAsQMAABYPAAB7GgAA4AUAAEURAACqHAAADwgAAHQTAADZHgAAPgoAAKMVAAAIAQAAbQwAANIXAAA3AwAA
| nA4AAAEaAABmBQAAyxAAADAcAACVBwAA+hIAAF8eAADECQAAKRUAAI4AAADzCwAAWBcAAL0CAAAiDgAAhxkAAOwEAABREAAA
| thsAABsHAACAEgAA5R0AAEoJAACvFAAAFAAAAHkLAADeFgAAQwIAAKgNAAANGQAAcgQAANcPAAA8GwAAoQYAAAYSAABrHQAA
| 0AgAADUUAACaHwAA/woAAGQWAADJAQAALg0AAJMYAAD4AwAAXQ8AAMIaAAAnBgAAjBEAAPEcAABWCAAAuxMAACAfAACFCgAA
| 6hUAAE8BAAC0DAAAGRgAAH4DAADjDgAASBoAAK0FAAASEQAAdxwAANwHAABBEwAAph4AAAsKAABwFQAA1QAAADoMAACfFwAA
| BAMAAGkOAADOGQAAMwUAAJgQAAD9GwAAYgcAAMcSAAAsHgAAkQkAAPYUAABbAAAAwAsAACUXAACKAgAA7w0AAFQZAAC5BAAA
| HhAAAIMbAADoBgAATRIAALIdAAAXCQAAfBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAACRsAAG4GAADTEQAA
| OB0AAJ0IAAACFAAAZx8AAMwKAAAxFgAAlgEAAPsMAABgGAAAxQMAACoPAACPGgAA9AUAAFkRAAC+HAAAIwgAAIgTAADtHgAA
| UgoAALcVAAAcAQAAgQwAAOYXAABLAwAAsA4AABUaAAB6BQAA3xAAAEQcAACpBwAADhMAAHMeAADYCQAAPRUAAKIAAAAHDAAA
| bBcAANECAAA2DgAAmxkAAAAFAABlEAAAyhsAAC8HAACUEgAA+R0AAF4JAADDFAAAKAAAAI0LAADyFgAAVwIAALwNAAAhGQAA
| hgQAAOsPAABQGwAAtQYAABoSAAB/HQAA5AgAAEkUAACuHwAAEwsAAHgWAADdAQAAQg0AAKcYAAAMBAAAcQ8AANYaAAA7BgAA
| oBEAAAUdAABqCAAAzxMAADQfAACZCgAA/hUAAGMBAADIDAAALRgAAJIDAAD3DgAAXBoAAMEFAAAmEQAAixwAAPAHAABVEwAA
| uh4AAB8KAACEFQAA6QAAAE4MAACzFwAAGAMAAH0OAADiGQAARwUAAKwQAAARHAAAuxMAACAfAACFCgAA6hUAAE8BAAC0DAAA
| GRgAAH4DAADjDgAASBoAAK0FAAASEQAAdxwAANwHAABBEwAAph4AAAsKAABwFQAA1QAAADoMAACfFwAABAMAAGkOAADOGQAA
| MwUAAJgQAAD9GwAAYgcAAMcSAAAsHgAAkQkAAPYUAABbAAAAwAsAACUXAACKAgAA7w0AAFQZAAC5BAAAHhAAAIMbAADoBgAA
| TRIAALIdAAAXCQAAfBQAAOEfAABGCwAAqxYAABACAAB1DQAA2hgAAD8EAACkDwAACRsAAG4GAADTEQAAOB0AAJ0IAAACFAAA
| Zx8AAMwKAAAxFgAAlgEAAPsMAABgGAAAxQMAACoPAACPGgAA9AUAAFkRAAC+HAAAIwgAAIgTAADtHgAAUgoAALcVAAAcAQAA
| gQwAAOYXAABLAwAAsA4AABUaAAB6BQAA3xAAAEQcAACpBwAADhMAAHMeAADYCQAAPRUAAKIAAAAHDAAAbBcAANECAAA2DgAA
| mxkAAAAFAABlEAAAyhsAAC8HAACUEgAA+R0AAF4JAADDFAAAKAAAAI0LAADyFgAAVwIAALwNAAAhGQAAhgQAAOsPAABQGwAA
| tQYAABoSAAB/HQAA5AgAAEkUAACuHwAAEwsAAHgWAADdAQAAQg0AAKcYAAAMBAAAcQ8AANYaAAA7BgAAoBEAAAUdAABqCAAA
| zxMAADQfAACZCgAA/hUAAGMBAADIDAAALRgAAJIDAAD3DgAAXBoAAMEFAAAmEQAAixwAAPAHAABVEwAAuh4AAB8KAACEFQAA
| 6QAAAE4MAACzFwAAGAMAAH0OAADiGQAARwUAAKwQAAARHAAAdgcAANsSAABAHgAApQkAAAoVAABvAAAA1AsAADkXAACeAgAA
| Aw4AAGgZAADNBAAAMhAAAJcbAAD8BgAAYRIAAMYdAAArCQAAkBQAAPUfAABaCwAAvxYAACQCAACJDQAA7hgAAFMEAAC4DwAA
| HRsAAIIGAADnEQAATB0AALEIAAAWFAAAex8AAOAKAABFFgAAqgEAAA8NAAB0GAAA2QMAAD4PAACjGgAACAYAAG0RAADSHAAA
| NwgAAJwTAAABHwAAZgoAAMsVAAAwAQAAlQwAAPoXAABfAwAAxA4AACkaAACOBQAA8xAAAFgcAAC9BwAAIhMAAIceAADsCQAA
| URUAALYAAAAbDAAAgBcAAOUCAABKDgAArxkAABQFAAB5EAAA3hsAAEMHAACoEgAADR4AAHIJAADXFAAAPAAAAKELAAAGFwAA
| awIAANANAAA1GQAAmgQAAP8PAABkGwAAyQYAAC4SAACTHQAA+AgAAF0UAADCHwAAJwsAAIwWAADxAQAAVg0AAA==
