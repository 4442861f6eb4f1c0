/** A ROS client without a library, which connects again whenever it is disconnected, and reads poses. */
const RETRY_MS = 100;

export class RosScript {
  readonly #url: string;
  #socket: WebSocket | null = null;
  #isClosed = false;
  /** number of received poses */
  poses = 0;

  /** @param url with a key in its path */
  constructor(url: string) {
    this.#url = url;
    this.#connect();
  }

  close(): void {
    this.#isClosed = true;
    this.#socket?.close();
  }

  #connect(): void {
    if (this.#isClosed) return;
    const socket = new WebSocket(this.#url);
    this.#socket = socket;
    socket.onopen = () => socket.send('{"op":"subscribe","topic":"/pose2d"}');
    socket.onmessage = () => (this.poses += 1);
    socket.onclose = () => setTimeout(() => this.#connect(), RETRY_MS);
  }
}
