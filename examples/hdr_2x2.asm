; 256 slots, 32000 us of light a frame
; 28 words stored in 5 kernels; 28 executed a frame in 5 launches, 9.4 us
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
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = false                    # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "b"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # High dynamic range from one exposure (class b): in each 2 x 2 tile one pixel closes after 4, one
| # after 16, one after 64 and one after 256 slots. Wherever the long exposure saturates, a
| # neighbour with a 64th of the light does not.
| nsl 1
|
| frame 256 slots of 125us            # 32 ms in all
|
| code stop : 1..256
| open when n < stop
|
| pixels stop = tile [[256, 64],
|                     [ 16,  4]]

.wait 125us x256

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 3 words, 1.5 us; launched at 4
    WHERE R1
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k2                               ; 3 words, 1.5 us; launched at 16
    WHERE R2
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k3                               ; 3 words, 1.5 us; launched at 64
    WHERE R3
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k4                               ; 11 words, 2.3 us; launched at 256
    WHERE R4
    bus NEWS, A, PIX
    bus A, B, NEWS
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4

.slot 0 k0
.slot 4 k1
.slot 16 k2
.slot 64 k3
.slot 256 k4

.bucket frame
.readout A frame 1

.load R1 R2 R3 R4
.fields stop
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0100000000000 0..3              ; 0
.shutter 0010000000000 0..15             ; 1
.shutter 0001000000000 0..63             ; 2
.shutter 0000100000000 0..255            ; 3
; a line a code: its shutter, then its fields
.code 0 4
.code 1 16
.code 2 64
.code 3 256

; the code of every pixel
.pixels tile 2 2
| 3 2
| 1 0
