/**
 * Garbage collection flags of V8 (decision 14). Import this before every other module.
 *
 * Marking is incremental, on the main thread. Concurrent marking finishes sooner but uses several
 * helper threads. A relay has little more than one core, so it would stall for 50 to 90 ms every
 * few seconds.
 *
 * Collection starts when the heap has tripled since the last collection. With many robots V8 would
 * start at 1.5 times the size, and a busy relay would spend half of its time in collection.
 */
import { setFlagsFromString } from "node:v8";

setFlagsFromString("--no-concurrent-marking");
setFlagsFromString("--heap-growing-percent=200");
