/**
 * How V8 looks for garbage (decision 14). Run before all else that is loaded.
 *
 * In small steps, by the thread that made it: helpers would do it at the same time, several at once, and be done sooner;
 * but a relay has hardly more than a core for itself, and for the 50 to 90 ms that they need every few seconds it would
 * wait for them with all that it serves. And only once there is twice as much new as there was left the last time: with many
 * robots V8 would begin at half as much, and a relay that has much to do does half of it while it looks.
 */
import { setFlagsFromString } from "node:v8";

setFlagsFromString("--no-concurrent-marking");
setFlagsFromString("--heap-growing-percent=200");
