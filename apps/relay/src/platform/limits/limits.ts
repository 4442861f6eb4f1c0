/**
 * Rates, counts and times that limit the clients of the relay, with their reasons. The relay rejects
 * excess requests with an error, or closes their connection. Limits of sizes are in the schemas of
 * `@corridor/protocol`, and those of requests in `relay.ts`.
 */
import {
  LONG_POLL_SECONDS,
  REPORT_RATE,
  SILENCE_MS,
  TILE_INTERVAL_MS,
  WATCHED_TILE_INTERVAL_MS,
} from "@corridor/protocol";

export const limits = {
  /** accepted, waiting commands of one robot; a script that far ahead of its robot is a mistake */
  waitingCommands: 64,
  /** least ms between two accepted resets of one robot */
  resetIntervalMs: 1_000,
  /** newest commands of one robot that are stored; an older one is deleted once it has ended */
  storedCommands: 10_000,
  /**
   * delivered commands that the page has not started; enough to hide the latency of the connection
   */
  deliveredWindow: 8,
  /** commands per driver key; faster than any robot can follow */
  commandRate: { perSecond: 20, burst: 40 },
  /** stops per driver key; more than a person can press; excess is answered with the open stop */
  stopRate: { perSecond: 5, burst: 20 },
  /** registrations per address; a class of 40 shares one address and reloads at the same time */
  registrationRate: { perSecond: 0.5, burst: 200 },
  /** stored documents per address; a class of 40 creates two short links each at the same time */
  documentRate: { perSecond: 1 / 30, burst: 80 },
  /** mazes that a robot's page publishes; one per edit, collected for half a second */
  mazeRate: { perSecond: 1, burst: 20 },
  /** messages of a script that mark cells of the maze */
  marksRate: { perSecond: 10, burst: 10 },
  /** a document expires this long after its last use; a use is stored at most once a day */
  documentIdleMs: 180 * 24 * 60 * 60 * 1000,
  documentNoteMs: 24 * 60 * 60 * 1000,
  /** lifetime of a pairing code */
  pairingMs: 10 * 60 * 1000,
  /**
   * checks per second after a wrong code, per address (which a class of 40 may share) and in total.
   * At 100 per second, finding one of 1,000 open codes among 25,600,000,000 takes 3 days on
   * average. Its owner must still accept.
   */
  codeChecks: { perSecond: 5, waiting: 50 },
  codeChecksForAll: { perSecond: 100, waiting: 50 },
  /** interval at which a waiting pairing request reads the changes of other relays */
  pairingPollMs: 500,
  /** waiting requests for one pairing, and for all pairings at this relay */
  waitsPerPairing: 4,
  pairingWaits: 400,
  /** script clocks per driver key; the least recently used clock is evicted */
  clocksPerKey: 64,
  /** open sockets, long-poll connections and event streams per driver key */
  readersPerKey: 4,
  /**
   * open connections and waiting requests of one robot; viewers have a separate limit of this size
   */
  readersPerRobot: 60,
  /** open responses of /check, and open sockets of /check, for all clients together */
  heldChecks: 100,
  /** sockets per address; a whole school may share one address */
  socketsPerAddress: 400,
  /** classes per address, which a school may share */
  classRate: { perSecond: 0.1, burst: 20 },
  /** right codes of classes per address; wrong ones are limited by `codeChecks` */
  joinRate: { perSecond: 5, burst: 200 },
  classIdleMs: 2 * 60 * 60 * 1000,
  classLifeMs: 12 * 60 * 60 * 1000,
  /** a code by which another device becomes a student */
  returnCodeMs: 10 * 60 * 1000,
  /** connections of students, dashboards and screens per address, which a school may share */
  classConnectionsPerAddress: 2_000,
  /** connections of dashboards and big screens of one class together */
  teacherConnections: 4,
  /** messages of one student; tiles are more frequent while a dashboard watches the student */
  studentRates: {
    tile: { perSecond: 1_000 / TILE_INTERVAL_MS, burst: 10 },
    "watched tile": { perSecond: 1_000 / WATCHED_TILE_INTERVAL_MS, burst: 10 },
    progress: REPORT_RATE,
    program: REPORT_RATE,
    help: { perSecond: 1, burst: 5 },
    name: { perSecond: 1, burst: 5 },
  },
  /** messages of one dashboard */
  teacherRates: {
    watch: { perSecond: 5, burst: 20 },
    hint: { perSecond: 5, burst: 20 },
    display: { perSecond: 2, burst: 4 },
  },
  /** interval of tiles to a dashboard, also while it watches a student; and of displays */
  tilesIntervalMs: TILE_INTERVAL_MS,
  watchedTilesIntervalMs: WATCHED_TILE_INTERVAL_MS,
  displayIntervalMs: 500,
  /** unacknowledged batches of tiles to a dashboard, and displays to a big screen */
  classCredit: 2,
  /** minimum interval between two messages of a class to other relays, with tiles or connections */
  classRelayIntervalMs: 250,
  /** a class without use for this long is not held in memory */
  classQuietMs: 10 * 60 * 1000,
  /** interval of snapshots to one reader; on a long-poll connection each one costs a request */
  snapshotIntervalMs: 50,
  longPollSnapshotIntervalMs: 100,
  /** unconfirmed snapshots to one reader; a sleeping reader finds no outdated ones when it wakes */
  snapshotCredit: 2,
  /** unread bytes above which the relay requests a reader's position */
  askReaderBytes: 8 * 1024,
  /** unread bytes above which a reader's states wait in the event log */
  heldReaderBytes: 32 * 1024,
  /** unsent bytes above which a reader is disconnected, because it does not read */
  stuckReaderBytes: 1024 * 1024,
  /**
   * interval at which a relay announces a robot that it holds to the page's relay, and a class to
   * all; without an announcement for `relaySilenceMs` it no longer counts
   */
  relayHereMs: 2_000,
  relaySilenceMs: 6_000,
  /** how long a relay that loads a robot waits for the newest snapshot from the page's relay */
  firstSnapshotWaitMs: 500,
  /** delay before the relay retries a failed store step that no request repeats */
  storeRetryMs: 250,
  /**
   * how long keys that may have changed stay valid without a response of the store, and the delay
   * before it is asked again
   */
  keysUnsureMs: 500,
  keysRetryMs: 200,
  /** unfinished messages of one page; a page sends at most about 20 ahead */
  unfinishedMessages: 128,
  /**
   * unanswered commands of one connection, and additional stops; twice the 64 that a script may
   * send ahead
   */
  unfinishedCommands: 128,
  unfinishedStops: 128,
  /** messages of a socket that wait until its key is checked; clients of Corridor send 2 */
  unauthenticatedMessages: { count: 32, bytes: 128 * 1024 },
  /** timeout for the first message of a socket */
  helloMs: 5_000,
  /**
   * interval of heartbeats, with a ping to a silent client; silence of more than twice that closes
   * the socket
   */
  heartbeatMs: 20_000,
  silenceMs: SILENCE_MS,
  /** interval of silence checks, and the maximum delay before a silent socket is closed */
  silenceCheckMs: 5_000,
  /** a long-poll connection without a request for this long is closed */
  longPollSilenceMs: 15_000,
  /**
   * a connected page without a tick for this long is asleep; checked once a second, reported within
   * 5 s
   */
  asleepMs: 3_500,
  /** time for a page to release the robot; it has little to report */
  yieldMs: 1_000,
  /** after this long, the commands of a disconnected page end */
  pageDisconnectedMs: 120_000,
  /** minimum interval between displays of commands that the page does not have */
  shownIntervalMs: 1_000,
  /** minimum interval between routine reports of scripts to the page */
  driversIntervalMs: 1_000,
  /** minimum interval between stored uses */
  touchMs: 60_000,
  robotIdleMs: 2 * 60 * 60 * 1000,
  robotLifeMs: 24 * 60 * 60 * 1000,
  /** longest long poll */
  longPollSeconds: LONG_POLL_SECONDS,
  /** commands in one response of the command log */
  logPage: 200,
  /**
   * consecutive too-fast commands of one script before it is disconnected; an accepted one resets
   * the count
   */
  tooFastInARow: 100,
  /** time to read the close frame of a connection before it is terminated */
  closingMs: 5_000,
  /** invalid messages of one script before it is disconnected */
  badFrames: 10,
} as const;
