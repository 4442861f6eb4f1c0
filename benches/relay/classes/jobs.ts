/** Requests to the process of students and dashboards, and its replies. Times are in milliseconds. */

export interface ClassesJob {
  /** of the relay */
  port: string;
  /** processes whose time is measured */
  pids: readonly number[];
  /** classes with one dashboard each */
  classes: number;
  /** students of each class */
  students: number;
  /** tiles of each student per second */
  tilesPerSecond: number;
  /** progress records of each class per second */
  recordsPerSecond: number;
  seconds: number;
  /** students who join one more class from one address at once */
  joins: number;
  /** pauses of a class whose network blocks WebSockets */
  longPollPauses: number;
}

export interface ClassesResult {
  seconds: number;
  /** number of tiles that students sent */
  tiles: number;
  /** number of progress records that the relay stored */
  stored: number;
  /** processor time of each process meanwhile */
  processorMs: number[];
  /** from sending a tile until the dashboard receives it */
  tileAges: number[];
  /** from the request to pause a class until all of its students have received it */
  pauses: number[];
  /** the same in a class whose network blocks WebSockets */
  longPollPauses: number[];
  /** from the code until the student is connected */
  joins: number[];
}
