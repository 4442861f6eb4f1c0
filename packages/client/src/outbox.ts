/** Sends messages in order, although some wait for a promise first. */
export class Outbox {
  #waiting: { send: () => void; isReady: boolean }[] = [];

  /**
   * Sends a message after all earlier ones; at once if none waits.
   * @param after resolves before the message is sent; it never rejects
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

  /** Drops all waiting messages. */
  clear(): void {
    this.#waiting = [];
  }

  #sendReady(): void {
    while (this.#waiting[0]?.isReady === true) this.#waiting.shift()?.send();
  }
}
