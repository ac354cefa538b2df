; 16 slots, 2000 us of light a frame
; 154 words stored in 17 kernels; 154 executed a frame in 17 launches, 39.8 us
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
| where_obeys_flag = true                    # does the analog `where` itself act only where FLAG is 1? (not public)
| or_sources = "any"                         # most sources of an OR or NOR word: "any" or a number (not public)
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
.note class "general"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # A clip in two readouts of one exposure. One is always open, as in an ordinary camera: where
| # nothing moves it is right, with all the light. In the other every pixel is open for a quarter of
| # the frame, from one of sixteen moments around the frame's end: where things move it says when.
| # `nscc demo CLIP --readouts 2` exposes with it; `nscc reconstruct any` joins the readouts.
| nsl 1
|
| frame 16 slots of 125us
| code phase : 0..N - 1
|
| bucket long open when true
| bucket short open when (n - phase) % N < 4
|
| pixels phase = tile [[ 0,  8,  2, 10],
|                      [12,  4, 14,  6],
|                      [ 3, 11,  1,  9],
|                      [15,  7, 13,  5]]

.wait 125us x16

.kernel k0                               ; 9 words, 2.8 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    bus B, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus C, NEWS

.kernel k1                               ; 8 words, 2.2 us; launched at 1
    NOR R0, R1, R4, R5, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R4, R6, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k2                               ; 8 words, 2.2 us; launched at 2
    NOR R0, R2, R4, R5, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R4, R6, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k3                               ; 8 words, 2.2 us; launched at 3
    NOR R0, R2, R3, R5, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R3, R6, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k4                               ; 8 words, 2.2 us; launched at 4
    NOR R0, R1, R3, R5, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R3, R6, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k5                               ; 8 words, 2.2 us; launched at 5
    NOR R0, R1, R4, R6, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R3, R6, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k6                               ; 8 words, 2.2 us; launched at 6
    NOR R0, R2, R4, R6, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R3, R6, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k7                               ; 8 words, 2.2 us; launched at 7
    NOR R0, R2, R3, R6, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R4, R6, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k8                               ; 8 words, 2.2 us; launched at 8
    NOR R0, R1, R3, R6, R8
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R4, R6, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k9                               ; 8 words, 2.2 us; launched at 9
    NOR R0, R1, R3, R6, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R4, R5, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k10                              ; 8 words, 2.2 us; launched at 10
    NOR R0, R2, R3, R6, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R4, R5, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k11                              ; 8 words, 2.2 us; launched at 11
    NOR R0, R2, R4, R6, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R3, R5, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k12                              ; 8 words, 2.2 us; launched at 12
    NOR R0, R1, R4, R6, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R3, R5, R7
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k13                              ; 8 words, 2.2 us; launched at 13
    NOR R0, R1, R4, R5, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R1, R4, R5, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k14                              ; 8 words, 2.2 us; launched at 14
    NOR R0, R2, R4, R5, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R4, R5, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k15                              ; 8 words, 2.2 us; launched at 15
    NOR R0, R2, R3, R5, R7
    WHERE R0
    bus NEWS, B, PIX
    bus B, C, NEWS
    NOR R0, R2, R3, R5, R8
    WHERE R0
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k16                              ; 25 words, 4 us; launched at 16
    all
    bus NEWS, A, PIX
    bus A, C, NEWS
    NOR R0, R1, R3, R5, R7
    NOR R9, R4, R5, R8
    NOR R10, R2, R5, R8
    WHERE R0, R9, R10
    bus NEWS, B, PIX
    bus B, C, NEWS
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4
    REFRESH R5
    REFRESH R6
    REFRESH R7
    REFRESH R8

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
.slot 14 k14
.slot 15 k15
.slot 16 k16

.bucket long short
.readout A long 1
.readout B short 1

.load R1 R2 R3 R4 R5 R6 R7 R8
.fields phase
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0010101010000 0..15 12..15      ; 0
.shutter 0100101010000 0..15 11..14      ; 1
.shutter 0101001010000 0..15 10..13      ; 2
.shutter 0011001010000 0..15 9..12       ; 3
.shutter 0011010010000 0..15 8..11       ; 4
.shutter 0101010010000 0..15 7..10       ; 5
.shutter 0100110010000 0..15 6..9        ; 6
.shutter 0010110010000 0..15 5..8        ; 7
.shutter 0010110100000 0..15 4..7        ; 8
.shutter 0100110100000 0..15 3..6        ; 9
.shutter 0101010100000 0..15 2..5        ; 10
.shutter 0011010100000 0..15 1..4        ; 11
.shutter 0011001100000 0..15 0,13..15    ; 12
.shutter 0101001100000 0..15 0..1,14..15 ; 13
.shutter 0100101100000 0..15 0..2,15     ; 14
.shutter 0010101100000 0..15 0..3        ; 15
; a line a code: its shutter, then its fields
.code 15 0
.code 11 1
.code 10 2
.code 9 3
.code 8 4
.code 7 5
.code 6 6
.code 5 7
.code 4 8
.code 3 9
.code 2 10
.code 1 11
.code 0 12
.code 12 13
.code 13 14
.code 14 15

; the code of every pixel
.pixels tile 4 4
| 0 8 2 10
| 12 4 14 6
| 3 11 1 9
| 15 7 13 5
