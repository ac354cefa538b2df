; 64 slots, 32000 us of light a frame
; 195 words stored in 20 kernels; 694 executed a frame in 65 launches, 157.8 us
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
| or_sources = "any"                         # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = 2                          # most sources of a WHERE word: "any" or a number (not public)
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
| in_low = -126                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "c"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # One bump of fixed length, beginning where each pixel says (class c): a video code in which
| # every pixel gathers the same light and neighbours look at different moments.
| nsl 1
|
| frame 64 slots of 500us
| let len = 8
|
| code start : 0..N - len
| open when start <= n < start + len
|
| pixels start = (8 * x + 16 * y) % (N - len + 1)

.wait 500us x64

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 4 words, 1.6 us; launched at 1
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k2                               ; 6 words, 1.8 us; launched at 2..6/2
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k3                               ; 6 words, 1.8 us; launched at 3,7
    NOT R8
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k4                               ; 6 words, 1.8 us; launched at 5
    NOT R9
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k5                               ; 10 words, 2.4 us; launched at 8
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k6                               ; 12 words, 2.6 us; launched at 9..41/16
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R10
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k7                               ; 12 words, 2.6 us; launched at 10..54/4
    NOT R2
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k8                               ; 12 words, 2.6 us; launched at 11..55/4
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R8
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k9                               ; 12 words, 2.6 us; launched at 12..52/8
    NOT R3
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k10                              ; 12 words, 2.6 us; launched at 13..53/8
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R9
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k11                              ; 12 words, 2.6 us; launched at 16..48/16
    NOT R4
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k12                              ; 13 words, 2.7 us; launched at 17,49
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    SET R0
    NOT R12
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k13                              ; 12 words, 2.6 us; launched at 24,56
    NOT R5
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k14                              ; 12 words, 2.6 us; launched at 33
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R11
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k15                              ; 12 words, 2.6 us; launched at 40
    NOT R6
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R7
    NOR R0, R7, R8, R9, R10, R11, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k16                              ; 6 words, 1.8 us; launched at 57..63/2
    NOT R1
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k17                              ; 6 words, 1.8 us; launched at 58,62
    NOT R2
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k18                              ; 6 words, 1.8 us; launched at 60
    NOT R3
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k19                              ; 16 words, 2.8 us; launched at 64
    NOT R4
    NOR R0, R1, R2, R3, R4, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOT R3
    NOT R6
    NOT R9
    NOT R10
    NOT R11

.slot 0 k0
.slot 1 k1
.slot 2..6/2 k2
.slot 3,7 k3
.slot 5 k4
.slot 8 k5
.slot 9..41/16 k6
.slot 10..54/4 k7
.slot 11..55/4 k8
.slot 12..52/8 k9
.slot 13..53/8 k10
.slot 16..48/16 k11
.slot 17,49 k12
.slot 24,56 k13
.slot 33 k14
.slot 40 k15
.slot 57..63/2 k16
.slot 58,62 k17
.slot 60 k18
.slot 64 k19

.bucket frame
.readout A frame 1

.load R12 R1 R2 R3 R4 R5 R6 R7 R8 R9 R10 R11
.fields start
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0001001001110 56..63            ; 0
.shutter 0001101101110 55..62            ; 1
.shutter 0101101111110 54..61            ; 2
.shutter 0111101011110 53..60            ; 3
.shutter 0011101010110 52..59            ; 4
.shutter 0010101110110 51..58            ; 5
.shutter 0110101100110 50..57            ; 6
.shutter 0100101000110 49..56            ; 7
.shutter 0000101000111 48..55            ; 8
.shutter 0000111100111 47..54            ; 9
.shutter 0100111110111 46..53            ; 10
.shutter 0110111010111 45..52            ; 11
.shutter 0010111011111 44..51            ; 12
.shutter 0011111111111 43..50            ; 13
.shutter 0111111101111 42..49            ; 14
.shutter 0101111001111 41..48            ; 15
.shutter 0001111001011 40..47            ; 16
.shutter 0001011101011 39..46            ; 17
.shutter 0101011111011 38..45            ; 18
.shutter 0111011011011 37..44            ; 19
.shutter 0011011010011 36..43            ; 20
.shutter 0010011110011 35..42            ; 21
.shutter 0110011100011 34..41            ; 22
.shutter 0100011000011 33..40            ; 23
.shutter 0000011000001 32..39            ; 24
.shutter 0000010100001 31..38            ; 25
.shutter 0100010110001 30..37            ; 26
.shutter 0110010010001 29..36            ; 27
.shutter 0010010011001 28..35            ; 28
.shutter 0011010111001 27..34            ; 29
.shutter 0111010101001 26..33            ; 30
.shutter 0101010001001 25..32            ; 31
.shutter 0001010001101 24..31            ; 32
.shutter 0001110101101 23..30            ; 33
.shutter 0101110111101 22..29            ; 34
.shutter 0111110011101 21..28            ; 35
.shutter 0011110010101 20..27            ; 36
.shutter 0010110110101 19..26            ; 37
.shutter 0110110100101 18..25            ; 38
.shutter 0100110000101 17..24            ; 39
.shutter 0000110000100 16..23            ; 40
.shutter 0000100100100 15..22            ; 41
.shutter 0100100110100 14..21            ; 42
.shutter 0110100010100 13..20            ; 43
.shutter 0010100011100 12..19            ; 44
.shutter 0011100111100 11..18            ; 45
.shutter 0111100101100 10..17            ; 46
.shutter 0101100001100 9..16             ; 47
.shutter 0001100001000 8..15             ; 48
.shutter 0001000101000 7..14             ; 49
.shutter 0101000111000 6..13             ; 50
.shutter 0111000011000 5..12             ; 51
.shutter 0011000010000 4..11             ; 52
.shutter 0010000110000 3..10             ; 53
.shutter 0110000100000 2..9              ; 54
.shutter 0100000000000 1..8              ; 55
.shutter 0000000001010 0..7              ; 56
; a line a code: its shutter, then its fields
.code 56 0
.code 55 1
.code 54 2
.code 53 3
.code 52 4
.code 51 5
.code 50 6
.code 49 7
.code 48 8
.code 47 9
.code 46 10
.code 45 11
.code 44 12
.code 43 13
.code 42 14
.code 41 15
.code 40 16
.code 39 17
.code 38 18
.code 37 19
.code 36 20
.code 35 21
.code 34 22
.code 33 23
.code 32 24
.code 31 25
.code 30 26
.code 29 27
.code 28 28
.code 27 29
.code 26 30
.code 25 31
.code 24 32
.code 23 33
.code 22 34
.code 21 35
.code 20 36
.code 19 37
.code 18 38
.code 17 39
.code 16 40
.code 15 41
.code 14 42
.code 13 43
.code 12 44
.code 11 45
.code 10 46
.code 9 47
.code 8 48
.code 7 49
.code 6 50
.code 5 51
.code 4 52
.code 3 53
.code 2 54
.code 1 55
.code 0 56

; the code of every pixel
.pixels tile 57 57
| 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49
| 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8
| 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24
| 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40
| 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56
| 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15
| 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31
| 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47
| 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6
| 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22
| 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38
| 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54
| 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13
| 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29
| 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45
| 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4
| 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20
| 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36
| 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52
| 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11
| 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27
| 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43
| 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2
| 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18
| 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34
| 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50
| 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9
| 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25
| 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41
| 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0
| 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16
| 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32
| 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48
| 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7
| 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23
| 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39
| 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55
| 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14
| 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30
| 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46
| 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5
| 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21
| 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37
| 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53
| 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12
| 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28
| 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44
| 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3
| 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19
| 43 51 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35
| 2 10 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51
| 18 26 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10
| 34 42 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26
| 50 1 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42
| 9 17 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1
| 25 33 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17
| 41 49 0 8 16 24 32 40 48 56 7 15 23 31 39 47 55 6 14 22 30 38 46 54 5 13 21 29 37 45 53 4 12 20 28 36 44 52 3 11 19 27 35 43 51 2 10 18 26 34 42 50 1 9 17 25 33
