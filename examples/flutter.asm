; 64 slots, 16000 us of light a frame
; 118 words stored in 17 kernels; 118 executed a frame in 17 launches, 35.8 us
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
| in_settle_us = 5000.0                      # time from setting IN to the first word that reads it (not public)
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
| # A fast scene in one frame: a pixel opens for a short bump at its own moment in a window of 64
| # slots, sixteen moments in a 4 x 4 tile. Neighbouring pixels together hold sixteen instants.
| nsl 1
|
| frame 64 slots of 250us             # 16 ms in all
| let moments = 16
| let len = N / moments
|
| code start : 0..N - len
| open when start <= n < start + len
|
| pixels start = len * ((5 * (x % 4) + 12 * (y % 4)) % moments)

.wait 250us x64

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 8 words, 2.2 us; launched at 4
    NOR R0, R1, R3, R5, R8
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R3, R5, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k2                               ; 6 words, 2 us; launched at 8
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R4, R5, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k3                               ; 6 words, 2 us; launched at 12
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R4, R5, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k4                               ; 6 words, 2 us; launched at 16
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R4, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k5                               ; 6 words, 2 us; launched at 20
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R4, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k6                               ; 6 words, 2 us; launched at 24
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R3, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k7                               ; 6 words, 2 us; launched at 28
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R3, R6, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k8                               ; 6 words, 2 us; launched at 32
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R3, R6, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k9                               ; 6 words, 2 us; launched at 36
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R3, R6, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k10                              ; 6 words, 2 us; launched at 40
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R4, R6, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k11                              ; 6 words, 2 us; launched at 44
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R4, R6, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k12                              ; 6 words, 2 us; launched at 48
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R4, R5, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k13                              ; 6 words, 2 us; launched at 52
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R4, R5, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k14                              ; 6 words, 2 us; launched at 56
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R3, R5, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k15                              ; 6 words, 2 us; launched at 60
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R3, R5, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k16                              ; 18 words, 3 us; launched at 64
    bus NEWS, A, PIX
    bus A, B, NEWS
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4
    REFRESH R5
    REFRESH R6
    REFRESH R7
    REFRESH R8

.slot 0 k0
.slot 4 k1
.slot 8 k2
.slot 12 k3
.slot 16 k4
.slot 20 k5
.slot 24 k6
.slot 28 k7
.slot 32 k8
.slot 36 k9
.slot 40 k10
.slot 44 k11
.slot 48 k12
.slot 52 k13
.slot 56 k14
.slot 60 k15
.slot 64 k16

.bucket frame
.readout A frame 1

.load R1 R2 R3 R4 R5 R6 R7 R8
.fields start
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0010101010000 60..63            ; 0
.shutter 0100101010000 56..59            ; 1
.shutter 0101001010000 52..55            ; 2
.shutter 0011001010000 48..51            ; 3
.shutter 0011010010000 44..47            ; 4
.shutter 0101010010000 40..43            ; 5
.shutter 0100110010000 36..39            ; 6
.shutter 0010110010000 32..35            ; 7
.shutter 0010110100000 28..31            ; 8
.shutter 0100110100000 24..27            ; 9
.shutter 0101010100000 20..23            ; 10
.shutter 0011010100000 16..19            ; 11
.shutter 0011001100000 12..15            ; 12
.shutter 0101001100000 8..11             ; 13
.shutter 0100101100000 4..7              ; 14
.shutter 0010101100000 0..3              ; 15
; a line a code: its shutter, then its fields
.code 15 0
.code 14 4
.code 13 8
.code 12 12
.code 11 16
.code 10 20
.code 9 24
.code 8 28
.code 7 32
.code 6 36
.code 5 40
.code 4 44
.code 3 48
.code 2 52
.code 1 56
.code 0 60

; the code of every pixel
.pixels tile 4 4
| 0 5 10 15
| 12 1 6 11
| 8 13 2 7
| 4 9 14 3
