/**
 * Terminates TLS in front of a relay, as the web server of a school does, with a certificate made
 * for this run.
 */
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { connect, type AddressInfo, type Socket } from "node:net";
import { join } from "node:path";
import { createServer, getCACertificates, setDefaultCACertificates, type Server } from "node:tls";
import { inPath } from "../../../scripts/programs.ts";

/** A key and its self-signed certificate for this machine, as PEM files. */
export interface Certificate {
  keyFile: string;
  file: string;
}

/**
 * Makes a certificate for 127.0.0.1 that is valid for a day.
 * @returns null if openssl is not installed
 */
export function makeCertificate(folder: string): Certificate | null {
  const [openssl] = inPath("openssl");
  if (openssl === undefined) return null;
  const certificate = { keyFile: join(folder, "key.pem"), file: join(folder, "certificate.pem") };
  const key = ["-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"];
  const name = ["-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1"];
  const files = ["-keyout", certificate.keyFile, "-out", certificate.file];
  const request = ["req", "-x509", ...key, ...name, "-days", "1", ...files];
  execFileSync(openssl, request, { stdio: "pipe" });
  return certificate;
}

/** Trusts a certificate in addition to the usual ones, in this process. */
export function trust({ file }: Certificate): void {
  setDefaultCACertificates([...getCACertificates("default"), readFileSync(file, "utf8")]);
}

export class TlsProxy {
  readonly #server: Server;
  readonly #sockets = new Set<Socket>();
  /** number of connections with a completed handshake */
  connections = 0;

  private constructor({ keyFile, file }: Certificate, target: () => number) {
    const options = { key: readFileSync(keyFile), cert: readFileSync(file) };
    this.#server = createServer(options, (client) => {
      this.connections += 1;
      this.#join(client, connect(target(), "127.0.0.1"));
    });
  }

  /** @param target port of this machine to connect to, requested for each connection */
  static async start(certificate: Certificate, target: () => number): Promise<TlsProxy> {
    const proxy = new TlsProxy(certificate, target);
    await new Promise<void>((resolve) => proxy.#server.listen(0, "127.0.0.1", resolve));
    return proxy;
  }

  get port(): number {
    return (this.#server.address() as AddressInfo).port;
  }

  async close(): Promise<void> {
    for (const socket of this.#sockets) socket.destroy();
    await new Promise((resolve) => this.#server.close(resolve));
  }

  #join(client: Socket, relay: Socket): void {
    for (const [socket, other] of [
      [client, relay],
      [relay, client],
    ] as const) {
      this.#sockets.add(socket);
      socket.setNoDelay(true);
      socket.pipe(other);
      socket.on("error", () => other.destroy());
      socket.on("close", () => {
        this.#sockets.delete(socket);
        other.end();
      });
    }
  }
}
