# The service on the official Node.js: docs/operations.md describes how to build and run it.
# The image uses glibc: the Node.js that `npm ci` installs for the build does not run on Alpine Linux.
FROM node:26-bookworm-slim AS build
WORKDIR /srv/corridor
COPY . .
RUN npm ci && npm run build
# Replace the packages of the build with those that the relay imports.
RUN npm ci --omit=dev --omit=optional --workspace @corridor/relay

FROM node:26-bookworm-slim
ENV NODE_ENV=production DATA_DIR=/data PORT=8080
RUN install -d -o node -g node /data
WORKDIR /srv/corridor
COPY --from=build /srv/corridor .
USER node
VOLUME /data
EXPOSE 8080
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=5s --start-period=60s \
  CMD ["node", "-e", "fetch(`http://127.0.0.1:${process.env.PORT}/readyz`).then((r) => process.exit(r.ok ? 0 : 1), () => process.exit(1))"]
CMD ["node", "apps/relay/src/main.ts"]
