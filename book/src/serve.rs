//! Shows the book on this machine, and builds it again when a page changes.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use common::chapter::Entry;
use common::interrupt;
use tiny_http::{Header, Method, Request, Response, Server};

use crate::places::Places;
use crate::site;
use crate::trouble::{Trouble, say};
use crate::watch::Snapshot;

/// How often files are looked at.
const PULSE: Duration = Duration::from_millis(400);

/// Builds the book and serves it until Ctrl-C.
pub fn run(
    places: &Places,
    chapters: &[&Entry],
    port: u16,
    out: &mut dyn Write,
) -> Result<(), Trouble> {
    // The port first: nobody should wait for a build to learn that it is taken.
    let server = Server::http(("127.0.0.1", port)).map_err(|error| {
        Trouble::Work(format!(
            "port {port} of 127.0.0.1 can't be used: {error}; choose another with --port"
        ))
    })?;
    let port = server.server_addr().to_ip().map_or(port, |address| address.port());
    let mut seen = look(places);
    report(site::build(places, chapters))?;
    writeln!(out, "The book is at http://127.0.0.1:{port}/ until you press Ctrl-C.")?;
    out.flush()?;
    let mut looked = Instant::now();
    while !interrupt::asked() {
        let request = server.recv_timeout(PULSE).map_err(Trouble::Output)?;
        if let Some(request) = request {
            // A reader who closes the page early is no reason to stop.
            let _answered = answer(request, &places.site);
        }
        if looked.elapsed() >= PULSE {
            let now = look(places);
            let changes = now.changes(&seen);
            seen = now;
            if !changes.is_empty() {
                again(places, chapters, &changes)?;
            }
            looked = Instant::now();
        }
    }
    Err(Trouble::Interrupted)
}

/// What the book is made from.
fn look(places: &Places) -> Snapshot {
    let folders = [
        places.text.clone(),
        places.book.join("book.toml"),
        places.book.join("first-light.css"),
        places.root.join("assets"),
        places.root.join("chapters"),
        places.root.join("common/src"),
    ];
    Snapshot::of(&folders)
}

fn again(places: &Places, chapters: &[&Entry], changes: &[PathBuf]) -> Result<(), Trouble> {
    let names = changes
        .iter()
        .map(|path| path.strip_prefix(&places.root).unwrap_or(path).display().to_string());
    say(format_args!("changed: {}", names.collect::<Vec<_>>().join(", ")));
    if changes.iter().any(|path| path.extension().is_some_and(|ending| ending == "rs")) {
        say(format_args!(
            "Listings follow the source at once. Pictures and numbers are still those of the old \
             code: press Ctrl-C and start again to compile the new."
        ));
    }
    report(site::build(places, chapters))
}

/// A wrong page is told and the old book stays; only Ctrl-C ends the program.
fn report(built: Result<PathBuf, Trouble>) -> Result<(), Trouble> {
    match built {
        Ok(_) => say(format_args!("the book is built")),
        Err(Trouble::Interrupted) => return Err(Trouble::Interrupted),
        Err(trouble) => say(format_args!("error: {trouble}")),
    }
    Ok(())
}

fn answer(request: Request, site: &Path) -> std::io::Result<()> {
    if !matches!(request.method(), Method::Get | Method::Head) {
        return request.respond(Response::from_string("only GET\n").with_status_code(405));
    }
    let opened = file_for(request.url(), site)
        .and_then(|path| File::open(&path).ok().map(|file| (file, content_type(&path))));
    match opened {
        Some((file, kind)) => {
            let mut response = Response::from_file(file);
            if let Ok(header) = Header::from_bytes("Content-Type", kind) {
                response.add_header(header);
            }
            if let Ok(header) = Header::from_bytes("Cache-Control", "no-cache") {
                response.add_header(header);
            }
            request.respond(response)
        }
        None => request.respond(Response::from_string("no such page\n").with_status_code(404)),
    }
}

/// The file for the path of a request; nothing for what is not a file of the book.
fn file_for(url: &str, site: &Path) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = decoded(path)?;
    let mut file = site.to_path_buf();
    for part in path.split('/') {
        // Windows' separators, drives and streams, and ways up, have no place in a name here.
        if part == ".." || part == "." || part.contains(['\\', ':', '\0']) {
            return None;
        }
        file.push(part);
    }
    let file = if file.is_dir() { file.join("index.html") } else { file };
    // A link in the folder may still lead out of it.
    let real = file.canonicalize().ok()?;
    (real.starts_with(site.canonicalize().ok()?) && real.is_file()).then_some(real)
}

/// A path with `%20` and its like written out.
fn decoded(path: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let mut digit = || char::from(rest.next()?).to_digit(16);
                u8::try_from(digit()? * 16 + digit()?).ok()?
            }
            other => other,
        });
    }
    String::from_utf8(bytes).ok()
}

/// What kind of file it is, by its ending.
fn content_type(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("ico") => "image/x-icon",
        Some("woff2") => "font/woff2",
        Some("txt") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Write};
    use std::net::TcpStream;

    use tiny_http::Server;

    use super::{answer, content_type, file_for};

    #[test]
    fn only_files_of_the_book_are_served() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let site = folder.path().join("book");
        std::fs::create_dir(&site).expect("it can be made");
        std::fs::write(site.join("index.html"), "i").expect("it can be written");
        std::fs::write(site.join("a b.html"), "a").expect("it can be written");
        std::fs::write(folder.path().join("secret"), "s").expect("it can be written");
        for good in ["/", "/index.html", "/index.html?x=1", "/a%20b.html"] {
            assert!(file_for(good, &site).is_some(), "{good}");
        }
        let absolute = format!("/{}", folder.path().join("secret").display());
        for bad in [
            "/../secret",
            "/%2e%2e/secret",
            "/..%2fsecret",
            "/x/../../secret",
            "/..\\secret",
            "secret",
            "/none.html",
            "/%zz",
            "/%",
            "/index.html/",
            &absolute,
            "/%00",
        ] {
            assert!(file_for(bad, &site).is_none(), "{bad}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_book_is_not_followed() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let site = folder.path().join("book");
        std::fs::create_dir(&site).expect("it can be made");
        std::fs::write(folder.path().join("secret"), "s").expect("it can be written");
        std::os::unix::fs::symlink("../secret", site.join("a.html")).expect("it can be made");
        assert!(file_for("/a.html", &site).is_none());
    }

    #[test]
    fn a_page_comes_with_its_type_and_nothing_can_be_posted() {
        let site = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(site.path().join("a.css"), "b {}").expect("it can be written");
        let server = Server::http("127.0.0.1:0").expect("a free port");
        let address = server.server_addr().to_ip().expect("it is an address");
        let ask = |words: &str| {
            let mut stream = TcpStream::connect(address).expect("it listens");
            let text = format!("{words} HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
            stream.write_all(text.as_bytes()).expect("it can be written");
            answer(server.recv().expect("a request"), site.path()).expect("it is answered");
            let mut answer = String::new();
            stream.read_to_string(&mut answer).expect("it can be read");
            answer
        };
        let page = ask("GET /a.css");
        assert!(page.starts_with("HTTP/1.1 200") && page.ends_with("b {}"), "{page}");
        assert!(page.contains("Content-Type: text/css"), "{page}");
        assert!(ask("GET /b.css").starts_with("HTTP/1.1 404"));
        assert!(ask("POST /a.css").starts_with("HTTP/1.1 405"));
        assert_eq!(content_type("x.woff2".as_ref()), "font/woff2");
    }
}
