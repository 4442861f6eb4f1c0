/**
 * Options for programs that run for seconds. Optimised code and concurrent garbage collection take
 * a third of their processor time, and do not pay off.
 */
export const shortRunOptions = ["-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"];

/** The same for the compiler. */
export const compilerOptions = shortRunOptions.map((option) => `-J${option}`);
