/**
 * Garbage is looked for in small steps by the thread that made it. V8's helpers would do it at the same time, several
 * at once, and be done sooner; but a relay has hardly more than a core for itself, and for the 50 to 90 ms that they
 * need every few seconds it would wait for them with all that it serves (decision 14). Run before all
 * else that is loaded.
 */
import { setFlagsFromString } from "node:v8";

setFlagsFromString("--no-concurrent-marking");
