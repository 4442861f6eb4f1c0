/** VIPLE as it connects to a robot: TCP, one object a line. It closes with the test. */
import { once } from "node:events";
import { connect, type Socket } from "node:net";
import { onTestFinished } from "vitest";

export class VipleClient {
  readonly socket: Socket;
  readonly #lineEnd: string;
  /** what arrived, with line ends */
  received = "";
  /** called for each line that arrives */
  onLine: (line: string) => void = () => undefined;

  private constructor(socket: Socket, lineEnd: string) {
    this.socket = socket;
    this.#lineEnd = lineEnd;
    let rest = "";
    socket.setEncoding("utf8").on("data", (text: string) => {
      this.received += text;
      const lines = (rest + text).split(lineEnd);
      rest = lines.pop() ?? "";
      for (const line of lines) this.onLine(line);
    });
    socket.on("error", () => undefined);
    onTestFinished(() => void socket.destroy());
  }

  static async open(port: number, lineEnd = "\n"): Promise<VipleClient> {
    const socket = connect(port, "127.0.0.1");
    await once(socket, "connect");
    return new VipleClient(socket, lineEnd);
  }

  /** Sends an object, or a text as it is, as a line. */
  send(message: object | string): void {
    const text = typeof message === "string" ? message : JSON.stringify(message);
    this.socket.write(text + this.#lineEnd);
  }
}
