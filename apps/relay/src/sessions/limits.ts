/** Every limit of the relay, with its unit and its reason. Excess is answered, never ignored. */
export const limits = {
  /** commands of one robot that are accepted and wait: a script far ahead of its robot is a mistake */
  waitingCommands: 64,
  /** newest commands of one robot that are kept; an older one is forgotten once it has ended */
  keptCommands: 10_000,
  /** commands delivered to the page and not yet started: enough to hide the line's delay */
  deliveredWindow: 8,
  /** commands of one driver key: faster than any robot can follow */
  commandRate: { perSecond: 20, burst: 40 },
  /** stops of one driver key: more than a panicking hand can press; more are answered with the open stop */
  stopRate: { perSecond: 5, burst: 20 },
  /** registrations from one address: a class of 40 shares one, and everybody reloads at once */
  registrationRate: { perSecond: 0.5, burst: 200 },
  /** documents stored from one address: a class of 40 makes two short links each at once */
  documentRate: { perSecond: 1 / 30, burst: 80 },
  /** mazes of one robot that its page gives: one for each edit, which it gathers for half a second */
  mazeRate: { perSecond: 1, burst: 20 },
  /** a document is in use for so long after the last time; a use is written down at most once a day */
  documentIdleMs: 180 * 24 * 60 * 60 * 1000,
  documentNoteMs: 24 * 60 * 60 * 1000,
  /** a pairing code counts for so long */
  pairingMs: 10 * 60 * 1000,
  /**
   * after a wrong code, checks a second: of one address, where a class of 40 may sit, and of all. 100 a second find one
   * of 1,000 open codes among 25,600,000,000 in 3 days on average, and then its owner still has to accept.
   */
  codeChecks: { perSecond: 5, waiting: 50 },
  codeChecksForAll: { perSecond: 100, waiting: 50 },
  /** whoever waits for a pairing hears within so long what came of it at another relay */
  pairingLookMs: 500,
  /** requests that wait for one pairing, and all of them at this relay */
  waitsPerPairing: 4,
  pairingWaits: 400,
  /** clocks of scripts that one driver key is timed by; the one that was heard longest ago is forgotten */
  clocksPerKey: 64,
  /** open sockets and event streams of one driver key */
  readersPerKey: 4,
  /** open sockets, event streams and waiting requests of one robot; watchers are as many besides */
  readersPerRobot: 60,
  /** answers and sockets of /check that are held at once, by anybody */
  heldChecks: 100,
  /** sockets from one address: a whole school may share one */
  socketsPerAddress: 400,
  /** snapshots pushed to one reader: 20 a second; by a line each one costs a request */
  snapshotIntervalMs: 50,
  lineSnapshotIntervalMs: 100,
  /** snapshots on their way to one reader: one that sleeps finds no old ones when it wakes */
  snapshotCredit: 2,
  /** a reader that has not taken so many bytes is asked how far it is */
  askReaderBytes: 8 * 1024,
  /** for a reader that has not taken so many bytes, states wait in the event log */
  heldReaderBytes: 32 * 1024,
  /** a reader with more unsent bytes is closed: it does not read at all */
  stuckReaderBytes: 1024 * 1024,
  /** a relay that holds a robot says so to the page's relay this often; silence of that length ends it */
  relayHereMs: 2_000,
  relaySilenceMs: 6_000,
  /** how long a relay that begins to hold a robot waits for the newest snapshot from the page's relay */
  relayMeetMs: 500,
  /** a step of the store that failed and that nobody will ask for again is tried again after so long */
  storeRetryMs: 250,
  /** how long keys count that may have changed while the store does not say; it is asked so often */
  keysUnsureMs: 500,
  keysRetryMs: 200,
  /** messages of one page that are taken and not done: it sends some 20 at most ahead */
  unfinishedMessages: 128,
  /** commands of one line that are not answered yet, and stops besides: a script may send 64 ahead, and twice that */
  unfinishedCommands: 128,
  unfinishedStops: 128,
  /** time for the first message of a socket */
  helloMs: 5_000,
  /** a heartbeat each so often, with a ping to a client that sent nothing; silence of more than twice that closes the socket */
  heartbeatMs: 20_000,
  silenceMs: 45_000,
  /** a silent socket is closed at most so much later */
  silenceCheckMs: 5_000,
  /** a line by HTTPS on which no request waits, and none comes for so long, is closed */
  lineSilenceMs: 15_000,
  /** a page that connects but does not tick for so long sleeps; looked for once a second, and told within 5 s */
  asleepMs: 3_500,
  /** how long a page that has the robot may take to give it up to another; it has little to tell */
  yieldMs: 1_000,
  /** a page away for so long has lost what it ran */
  pageAwayMs: 120_000,
  /** the page is shown commands that it does not have at most so often */
  shownIntervalMs: 1_000,
  /** the page hears of its scripts at most so often */
  driversIntervalMs: 1_000,
  /** "in use" is written down at most so often */
  touchMs: 60_000,
  sessionIdleMs: 2 * 60 * 60 * 1000,
  sessionLifeMs: 24 * 60 * 60 * 1000,
  /** longest wait of a long poll: below the 30 s at which many proxies give up */
  longPollSeconds: 25,
  /** commands in one answer of the log */
  logPage: 200,
  /** commands of one script refused as too fast, with none taken in between, before its socket is closed */
  tooFastInARow: 100,
  /** time to read the goodbye of a connection before it is cut */
  goodbyeMs: 5_000,
  /** unreadable messages of one script before its socket is closed */
  badFrames: 10,
} as const;
