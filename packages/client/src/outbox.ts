/** Messages in their order, of which some wait for something else to be done first. */
export class Outbox {
  #waiting: { send: () => void; isReady: boolean }[] = [];

  /**
   * Sends a message after those before it; at once where none waits.
   * @param after what must be done before; it never rejects
   */
  send(send: () => void, after?: Promise<void>): void {
    if (after === undefined && this.#waiting.length === 0) return send();
    const message = { send, isReady: after === undefined };
    this.#waiting.push(message);
    void after?.then(() => {
      message.isReady = true;
      this.#sendReady();
    });
  }

  /** Drops what waits. */
  clear(): void {
    this.#waiting = [];
  }

  #sendReady(): void {
    while (this.#waiting[0]?.isReady === true) this.#waiting.shift()?.send();
  }
}
