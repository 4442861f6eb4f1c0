/** A bridge of the command line in its own process, which ends with the test. */
import { spawn, type ChildProcessByStdio } from "node:child_process";
import { once } from "node:events";
import type { Readable } from "node:stream";
import { fileURLToPath } from "node:url";
import { onTestFinished } from "vitest";

export const MAIN = fileURLToPath(new URL("../../../apps/cli/src/main.ts", import.meta.url));

export class BridgeProcess {
  readonly #child: ChildProcessByStdio<null, Readable, Readable>;
  /** resolves with its exit code, or the signal that killed it */
  readonly exited: Promise<number | string | null>;
  /** what it printed to standard output and standard error */
  output = { stdout: "", stderr: "" };

  private constructor(args: readonly string[], environment: Record<string, string>) {
    this.#child = spawn(process.execPath, [MAIN, ...args], {
      env: { ...process.env, ...environment },
      stdio: ["ignore", "pipe", "pipe"],
    });
    for (const name of ["stdout", "stderr"] as const) {
      this.#child[name].on("data", (data: Buffer) => (this.output[name] += data.toString()));
    }
    this.exited = once(this.#child, "close").then(([code, signal]) => code ?? signal);
    onTestFinished(async () => {
      this.#child.kill("SIGKILL");
      await this.exited;
    });
  }

  /** Starts it. It may exit at once. */
  static launch(args: readonly string[], environment: Record<string, string> = {}): BridgeProcess {
    return new BridgeProcess(args, environment);
  }

  /**
   * Starts rosbridge on a free port, with the address in the environment.
   * @returns it, and the URL for ROS clients
   */
  static async startRos(address: string): Promise<{ bridge: BridgeProcess; url: string }> {
    const bridge = BridgeProcess.launch(["ros", "--port", "0"], { CORRIDOR_ROBOT: address });
    const [, url = ""] = await bridge.says(/ROS clients connect to (\S+)\./);
    return { bridge, url };
  }

  /** Starts the bridge for VIPLE on free ports, with the address in the environment. */
  static async startViple(
    address: string,
    ...options: string[]
  ): Promise<{ bridge: BridgeProcess; simulatorPort: number; robotPort: number }> {
    const ports = ["--simulator-port", "0", "--robot-port", "0"];
    const environment = { CORRIDOR_ROBOT: address };
    const bridge = BridgeProcess.launch(["viple", ...ports, ...options], environment);
    const [, simulatorPort, robotPort] = await bridge.says(
      /VIPLE connects to .*port (\d+) .*port (\d+) /,
    );
    return { bridge, simulatorPort: Number(simulatorPort), robotPort: Number(robotPort) };
  }

  /** Waits until standard error matches. @throws Error if it exits before */
  async says(pattern: RegExp): Promise<RegExpExecArray> {
    for (;;) {
      const match = pattern.exec(this.output.stderr);
      if (match !== null) return match;
      const { exitCode, signalCode, stderr } = this.#child;
      const end = exitCode ?? signalCode;
      if (end !== null) throw new Error(`The bridge exited with ${end}: ${this.output.stderr}`);
      await Promise.race([once(stderr, "data"), this.exited]);
    }
  }

  get pid(): number {
    return this.#child.pid ?? 0;
  }

  signal(signal: NodeJS.Signals): void {
    this.#child.kill(signal);
  }
}
