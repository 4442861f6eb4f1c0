/** A WebSocket if the network permits it, else long polling over HTTPS. */
export type Transport = "websocket" | "long-poll";

/** How a connection ended. */
export interface ConnectionEnd {
  /** ms since the relay's welcome; null if there was none */
  lifetimeMs: number | null;
  /** whether relay or client closed the connection, so that no network filter is to blame */
  isDeliberate: boolean;
}

/** A filter that closes WebSockets does so early and repeatedly. */
const SHORT_LIFETIME_MS = 60_000;
const IMMEDIATELY_MS = 5_000;
const SHORT_LIFETIMES = 2;
/**
 * Attempts before the fallback on a network where WebSockets worked: the relay may be restarting.
 */
const ATTEMPTS = 3;
const FIRST_PROBE_MS = 15_000;
const MAX_PROBE_MS = 600_000;

/**
 * Chooses the transport of the next connection. Only the ends of earlier connections reveal whether
 * a network blocks WebSockets.
 */
export class TransportChoice {
  #transport: Transport = "websocket";
  #shortLifetimes = 0;
  #hasWorked = false;
  #failedInARow = 0;
  #probeMs = FIRST_PROBE_MS;

  /** The transport of the current or next connection. */
  get transport(): Transport {
    return this.#transport;
  }

  /** ms until the next probe for a WebSocket, while a long-poll connection works. */
  get probeMs(): number {
    return this.#probeMs;
  }

  /** The relay has sent its welcome on the connection. */
  welcomed(): void {
    this.#failedInARow = 0;
  }

  /**
   * A connection was lost.
   * @returns whether to connect by the other transport at once, without a delay
   */
  lost({ lifetimeMs, isDeliberate }: ConnectionEnd): boolean {
    if (this.#transport === "long-poll") {
      // Both transports fail: network or relay are down, and a WebSocket may work after that.
      if (lifetimeMs === null) this.#transport = "websocket";
      return false;
    }
    if (isDeliberate) return false;
    if (lifetimeMs === null) {
      this.#failedInARow += 1;
      const isRetried = this.#hasWorked && this.#failedInARow < ATTEMPTS;
      return isRetried ? false : this.#fallBack();
    }
    if (lifetimeMs >= IMMEDIATELY_MS) this.#hasWorked = true;
    else if (!this.#hasWorked) return this.#fallBack();
    this.#shortLifetimes = lifetimeMs < SHORT_LIFETIME_MS ? this.#shortLifetimes + 1 : 0;
    return this.#shortLifetimes >= SHORT_LIFETIMES ? this.#fallBack() : false;
  }

  /**
   * A probe has opened a WebSocket: the next connection uses one. Later probes are less frequent.
   */
  websocketOpened(): void {
    this.#transport = "websocket";
    this.#doubleProbeInterval();
  }

  /** A probe has failed. */
  websocketFailed(): void {
    this.#doubleProbeInterval();
  }

  #doubleProbeInterval(): void {
    this.#probeMs = Math.min(MAX_PROBE_MS, this.#probeMs * 2);
  }

  #fallBack(): boolean {
    this.#transport = "long-poll";
    this.#shortLifetimes = 0;
    this.#failedInARow = 0;
    return true;
  }
}
